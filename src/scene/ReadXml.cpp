#include "scene/ReadXml.hpp"

#include "base/EntryValue.hpp"
#include "base/Numbers.hpp"
#include "scene/NearestName.hpp"
#include "scene/UnitText.hpp"
#include "scene/Utf8.hpp"
#include "scene/ValueWithUnit.hpp"
#include "scene/XmlAttributes.hpp"

#include <Teuchos_Array.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterEntry;
using Teuchos::ParameterList;

const std::vector<std::string> knownTypes = {"double", "int",           "bool",
                                             "string", "Array(double)", "Array(int)"};

const std::string formOfParameter = "write <Parameter name=\"...\" type=\"...\" value=\"...\"/>.";

/// Adds a parameter with the value that a text says. \return whether the text is a value of the type
bool setFromText(ParameterList& list, const std::string& name, const std::string& type,
                 const std::string& text)
{
  if (type == "string")
    addValue(list, name, text);
  else if (type == "Array(string)")
    try
    {
      addValue(list, name, Teuchos::fromStringToArray<std::string>(text));
    }
    catch (const std::exception&)
    {
      return false;
    }
  else if (type == "bool")
  {
    const std::string word = trimmed(text);
    const bool yes = word == "true" || word == "True" || word == "TRUE";
    if (!yes && word != "false" && word != "False" && word != "FALSE")
      return false;
    addValue(list, name, yes);
  }
  else if (type == "int")
  {
    const auto value = parseInteger(text);
    if (!value)
      return false;
    addValue(list, name, *value);
  }
  else if (type == "double")
  {
    const auto value = parseReal(text);
    if (!value || !std::isfinite(*value))
      return false;
    addValue(list, name, *value);
  }
  else
  {
    const auto values = parseReals(text);
    if (!values || !std::all_of(values->begin(), values->end(), [](double x) { return std::isfinite(x); }))
      return false;
    if (type == "Array(double)")
    {
      addValue(list, name, Teuchos::Array<double>(*values));
      return true;
    }
    Teuchos::Array<int> whole;
    for (const double value : *values)
    {
      const auto integer = wholeNumber(value);
      if (!integer)
        return false;
      whole.push_back(*integer);
    }
    addValue(list, name, whole);
  }
  return true;
}

/// The message for a text that is not a value of the type.
std::string wrongValue(const std::string& type, const std::string& text)
{
  if (type == "Array(string)")
    return "\"" + text + "\" is not a list of texts; write {one, two}.";
  const bool array = type.rfind("Array", 0) == 0;
  const auto values = array ? parseReals(text) : parseReal(text) ? parseReals(text) : std::nullopt;
  bool finite = true;
  if (values)
    for (const double value : *values)
      finite = finite && std::isfinite(value);
  const std::string found = "\"" + text + "\" ";
  if (type == "bool")
    return found + "is neither true nor false; write value=\"true\" or value=\"false\".";
  if (!finite)
    return found + "is not finite; write a finite number.";
  if (type == "int" || type == "Array(int)")
    return values ? found + "is out of the range of whole numbers; write a smaller number."
                  : found + (array ? "is not a list of whole numbers; write {1, 2}."
                                   : "is not a whole number; write digits only.");
  if (const auto quantity = quantityOf(text))
    return found + "is not " + (array ? "a list of numbers" : "a number") + "; write value=\"" +
           quantity->value + "\" unit=\"" + quantity->unit + "\".";
  return array ? found + "is not a list of numbers; write {1.0, 2.0}."
               : found + "is not a number; write digits only, such as 1.5e-3.";
}

/// Tags that are nested deeper are those of no scene, or most are never closed.
constexpr std::size_t deepest = 100;

/// Copies the valid part of the XML and reports the rest.
class Cleaner
{
public:
  Cleaner(XmlReader& xml, std::vector<SceneError>& errors) : m_xml(xml), m_errors(errors) {}

  /// Reads all that is in the top list, whose tag was read last. Throws XmlError.
  /// \return whether the tags are nested no deeper than those of a scene
  bool read(ParameterList& top)
  {
    reportAttributes("");
    m_open.push_back({Kind::List, "", &top, false, {}});
    while (!m_open.empty())
      switch (m_xml.next())
      {
      case XmlReader::Item::Opening:
        if (m_open.size() >= deepest)
          return false;
        open();
        break;
      case XmlReader::Item::Text:
        refuseText();
        break;
      default:
        close();
      }
    m_xml.next(); // throws where more follows
    return true;
  }

private:
  enum class Kind
  {
    List,
    Parameter,
    Validators, ///< end of every list that Teuchos writes
    Left        ///< out, with all that is in it
  };

  /// An element that is not yet closed.
  struct Element
  {
    Kind kind;
    std::string name;
    ParameterList* list;            ///< that it is, or that it is in
    bool refused;                   ///< for a text in it
    std::vector<std::string> unset; ///< names of parameters that are not set, for they have an error
  };

  /// Path of the innermost open element.
  std::string path() const
  {
    std::string path;
    for (const Element& element : m_open)
      path = element.name.empty() ? path : scenePath(path, element.name);
    return path;
  }

  void open()
  {
    const std::string* const named = m_xml.find("name");
    const std::string asWritten = named != nullptr ? *named : std::string(), name = printable(asWritten);
    reportAttributes(name);
    Element& above = m_open.back();
    if (above.kind == Kind::Validators)
    {
      report("", unknownTag("Validators"));
      above.kind = Kind::Left;
    }
    const Kind kind = above.kind == Kind::List ? kindOf(asWritten) : Kind::Left;
    ParameterList* const list =
        kind == Kind::List ? &addValue(*above.list, name, ParameterList(above.list->name() + "->" + name))
                           : above.list;
    m_open.push_back({kind, name, list, false, {}});
    m_unit.reset();
    if (const std::string* const unit = kind == Kind::Parameter ? m_xml.find("unit") : nullptr;
        unit != nullptr)
      m_unit = *unit;
    for (auto& [attribute, value] : m_parameter)
    {
      const std::string* const given = kind == Kind::Parameter ? m_xml.find(attribute) : nullptr;
      value = given != nullptr ? std::optional<std::string>(*given) : std::nullopt;
    }
  }

  /// What a tag in a list is; reports what it can't be.
  Kind kindOf(const std::string& name)
  {
    const bool sublist = m_xml.tag() == "ParameterList";
    if (m_xml.tag() == "Validators" && m_open.size() == 1)
      return Kind::Validators;
    if (!sublist && m_xml.tag() != "Parameter")
      report(path(), unknownTag(m_xml.tag()));
    else if (trimmed(name).empty())
      report(path(), sublist ? "a <ParameterList> has no name; write <ParameterList name=\"...\">."
                             : "a <Parameter> has no name; " + formOfParameter);
    else if (const std::string mistake = mistakeInName(name); !mistake.empty())
      report(scenePath(path(), printable(name)), mistake);
    else if (isTaken(m_open.back(), name))
      report(scenePath(path(), name), "the name is given twice; keep one of the two.");
    else
      return sublist ? Kind::List : Kind::Parameter;
    return Kind::Left;
  }

  static bool isTaken(const Element& list, const std::string& name)
  {
    return list.list->isParameter(name) ||
           std::find(list.unset.begin(), list.unset.end(), name) != list.unset.end();
  }

  static std::string unknownTag(std::string_view tag)
  {
    return "<" + std::string(tag) + "> is unknown here; write <ParameterList> or <Parameter>.";
  }

  void close()
  {
    const Element& element = m_open.back();
    const bool unset = element.kind == Kind::Parameter && (element.refused || !setParameter(element));
    const std::string name = unset ? element.name : std::string();
    m_open.pop_back();
    if (unset)
      m_open.back().unset.push_back(name);
  }

  /// \return whether type and value are right
  bool setParameter(const Element& element)
  {
    for (const auto& [attribute, value] : m_parameter)
      if (!value)
      {
        report(path(), std::string("has no ").append(attribute).append("; ").append(formOfParameter));
        return false;
      }
    std::string type = trimmed(*m_parameter[0].second);
    if (type == "float" || type == "Array(float)") // a wider type here than in the file
      type.replace(type.find("float"), 5, "double");
    if (type == "long long" || type == "long" || type == "unsigned int")
      type = "int";
    const std::string& text = *m_parameter[1].second;
    const bool known =
        type == "Array(string)" || std::find(knownTypes.begin(), knownTypes.end(), type) != knownTypes.end();
    if (known && setFromText(*element.list, element.name, type, text))
    {
      if (m_unit)
      {
        ParameterEntry& entry = element.list->getEntry(element.name);
        ValueWithUnit given{entry, *m_unit};
        entry.setValue(given);
      }
      return true;
    }
    report(path(), known ? wrongValue(type, text)
                         : "the type \"" + type + "\" is unknown; " + suggestion(type, knownTypes));
    return false;
  }

  /// Reports the first text outside of the tags that an element holds.
  void refuseText()
  {
    Element& element = m_open.back();
    if (element.refused || (element.kind != Kind::List && element.kind != Kind::Parameter))
      return;
    element.refused = true;
    const std::string_view content = m_xml.content();
    const std::string line = trimmed(std::string(content.substr(0, content.find('\n'))));
    report(path(), "the text \"" + line.substr(0, 40) + "\" is outside of any parameter; " + formOfParameter);
  }

  void reportAttributes(const std::string& name)
  {
    if (const std::string mistake = mistakeInAttributes(m_xml); !mistake.empty())
      report(m_open.empty() ? "" : scenePath(path(), name),
             "line " + std::to_string(m_xml.line()) + ": " + mistake);
  }

  void report(const std::string& where, const std::string& message) { m_errors.push_back({where, message}); }

  XmlReader& m_xml;
  std::vector<SceneError>& m_errors;
  std::vector<Element> m_open;
  /// Of the open parameter.
  std::array<std::pair<const char*, std::optional<std::string>>, 2> m_parameter{
      {{"type", std::nullopt}, {"value", std::nullopt}}};
  std::optional<std::string> m_unit; ///< likewise
};

} // namespace

Teuchos::RCP<Teuchos::ParameterList> parseXml(const std::string& xml, const std::string& topName,
                                              std::vector<SceneError>& errors)
{
  const std::string start = "; a scene starts with <ParameterList name=\"" + topName + "\">.";
  const auto refuse = [&](const std::string& reason)
  {
    errors.push_back({"", reason + start});
    return Teuchos::null;
  };
  const std::string byteOrderMark = "\xEF\xBB\xBF";
  const std::string rest =
      xml.rfind(byteOrderMark, 0) == 0 ? xml.substr(byteOrderMark.size()) : std::string();
  const std::string& text = rest.empty() ? xml : rest;
  if (xml.rfind("\xFF\xFE", 0) == 0 || xml.rfind("\xFE\xFF", 0) == 0)
    return refuse("the file is in UTF-16; save it in UTF-8");
  XmlReader reader(text);
  try
  {
    reader.next();
    if (reader.tag() != "ParameterList")
      return refuse("the file starts with <" + std::string(reader.tag()) + ">");
    const std::string* const name = reader.find("name");
    if (name == nullptr || name->empty())
      return refuse("the top list has no name");
    if (*name != topName)
      return refuse("the top list is \"" + *name + "\"");
    if (const std::size_t at = firstNotUtf8(text); at != std::string::npos)
      return refuse("line " + std::to_string(reader.lineOf(at)) + ": " + foreignByteText(text[at]) +
                    "; save the file in UTF-8, for example with iconv -f ISO-8859-1 -t UTF-8");
    const auto list = Teuchos::parameterList(topName);
    std::vector<SceneError> found;
    if (!Cleaner(reader, found).read(*list))
      return refuse("the tags are nested more than " + std::to_string(deepest) +
                    " deep, or most are never closed");
    errors.insert(errors.end(), found.begin(), found.end());
    return list;
  }
  catch (const XmlError& error)
  {
    return refuse(std::string("not well-formed XML: ") + error.what());
  }
}

} // namespace Rhegma
