#include "scene/ReadXml.hpp"

#include "base/Numbers.hpp"
#include "scene/NearestName.hpp"
#include "scene/XmlAttributes.hpp"

#include <Teuchos_Array.hpp>
#include <Teuchos_StringInputSource.hpp>
#include <Teuchos_TestForException.hpp>
#include <Teuchos_XMLObject.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>
#include <sstream>

namespace Rhegma
{

namespace
{

using Teuchos::ParameterList;
using Teuchos::XMLObject;

const std::vector<std::string> knownTypes = {"double", "int",           "bool",
                                             "string", "Array(double)", "Array(int)"};

const std::string howToWrite = "write <Parameter name=\"...\" type=\"...\" value=\"...\"/>.";

/// Sets a parameter to what a text says. \return whether the text is a value of the type
bool setFromText(ParameterList& list, const std::string& name, const std::string& type,
                 const std::string& text)
{
  if (type == "string")
    list.set(name, text);
  else if (type == "Array(string)")
    list.set(name, Teuchos::fromStringToArray<std::string>(text));
  else if (type == "bool")
  {
    const std::string word = trimmed(text);
    const bool yes = word == "true" || word == "True" || word == "TRUE";
    if (!yes && word != "false" && word != "False" && word != "FALSE")
      return false;
    list.set(name, yes);
  }
  else if (type == "int")
  {
    const auto value = parseInteger(text);
    if (!value)
      return false;
    list.set(name, *value);
  }
  else if (type == "double")
  {
    const auto value = parseReal(text);
    if (!value || !std::isfinite(*value))
      return false;
    list.set(name, *value);
  }
  else
  {
    const auto values = parseReals(text);
    Teuchos::Array<int> whole;
    for (const double value : values.value_or(std::vector<double>()))
    {
      const auto integer = wholeNumber(value);
      if (!std::isfinite(value) || (type == "Array(int)" && !integer))
        return false;
      whole.push_back(integer.value_or(0));
    }
    if (values && type == "Array(int)")
      list.set(name, whole);
    else if (values)
      list.set(name, Teuchos::Array<double>(*values));
    return values.has_value();
  }
  return true;
}

/// The message for a text that is not a value of the type.
std::string wrongValue(const std::string& type, const std::string& text)
{
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
  return array ? found + "is not a list of numbers; write {1.0, 2.0}."
               : found + "is not a number; write digits only, such as 1.5e-3, without a unit.";
}

/// Copies the valid part of the XML and reports the rest.
class Cleaner
{
public:
  explicit Cleaner(std::vector<SceneError>& errors) : m_errors(errors) {}

  void list(const XMLObject& xml, const std::string& path, ParameterList& clean)
  {
    std::set<std::string> names;
    refuseText(xml, path);
    for (int i = 0; i < xml.numChildren(); ++i)
      child(xml.getChild(i), path, names, clean);
  }

private:
  void child(const XMLObject& xml, const std::string& path, std::set<std::string>& names,
             ParameterList& clean)
  {
    const bool sublist = xml.getTag() == "ParameterList";
    if (xml.getTag() == "Validators" && path.empty() && xml.numChildren() == 0)
      return; // end of every list that Teuchos writes
    if (!sublist && xml.getTag() != "Parameter")
    {
      report(path, "<" + xml.getTag() + "> is unknown here; write <ParameterList> or <Parameter>.");
      return;
    }
    const std::string name = xml.hasAttribute("name") ? xml.getAttribute("name") : "";
    if (trimmed(name).empty())
    {
      report(path, sublist ? "a <ParameterList> has no name; write <ParameterList name=\"...\">."
                           : "a <Parameter> has no name; " + howToWrite);
      return;
    }
    const std::string where = scenePath(path, name);
    if (!names.insert(name).second)
    {
      report(where, "the name is given twice; keep one of the two.");
      return;
    }
    if (sublist)
      list(xml, where, clean.sublist(name));
    else
      parameter(xml, where, clean);
  }

  void parameter(const XMLObject& xml, const std::string& where, ParameterList& clean)
  {
    if (refuseText(xml, where))
      return;
    for (const std::string attribute : {"type", "value"})
      if (!xml.hasAttribute(attribute))
      {
        report(where, std::string("has no ").append(attribute).append("; ").append(howToWrite));
        return;
      }
    std::string type = trimmed(xml.getAttribute("type"));
    if (type == "float" || type == "Array(float)") // a wider type here than in the file
      type.replace(type.find("float"), 5, "double");
    if (type == "long long" || type == "long" || type == "unsigned int")
      type = "int";
    if (type != "Array(string)" && std::find(knownTypes.begin(), knownTypes.end(), type) == knownTypes.end())
    {
      report(where, "the type \"" + type + "\" is unknown; " + suggestion(type, knownTypes));
      return;
    }
    const std::string text = xml.getAttribute("value");
    if (!setFromText(clean, xml.getAttribute("name"), type, text))
      report(where, wrongValue(type, text));
  }

  /// Reports a text outside of the tags; whether there is one.
  bool refuseText(const XMLObject& xml, const std::string& where)
  {
    for (int i = 0; i < xml.numContentLines(); ++i)
    {
      const std::string line = trimmed(xml.getContentLine(i));
      if (line.empty())
        continue;
      report(where, "the text \"" + line.substr(0, 40) + "\" is outside of any parameter; " + howToWrite);
      return true;
    }
    return false;
  }

  void report(const std::string& where, const std::string& message) { m_errors.push_back({where, message}); }

  std::vector<SceneError>& m_errors;
};

/// The message of Teuchos without the position in its source.
std::string parserReason(const std::string& what)
{
  const std::string mark = "XML parse error at ";
  const auto begin = what.rfind(mark);
  if (begin == std::string::npos)
    return what.find("empty XML") != std::string::npos ? "the file holds no element" : "the file is not XML";
  std::string reason = trimmed(what.substr(begin + mark.size()));
  return reason.substr(0, reason.find('\n'));
}

/// Larger than any scene, and small enough to read at once: a device or a pipe may be endless.
constexpr std::size_t mostBytes = 256u << 20;

/// \return whether the stream ended before
bool readUpTo(std::size_t most, std::istream& in, std::string& text)
{
  char piece[65536];
  while (text.size() <= most && (in.read(piece, sizeof piece) || in.gcount() > 0))
    text.append(piece, static_cast<std::size_t>(in.gcount()));
  return text.size() <= most;
}

/// Deepest nesting of tags; the parser calls itself for each and would run out of stack.
int deepestNesting(const std::string& text)
{
  int depth = 0, deepest = 0;
  for (std::size_t at = text.find('<'); at < text.size();)
  {
    const std::size_t end = endOfTag(text, at);
    const char next = at + 1 < text.size() ? text[at + 1] : ' ';
    if (next == '/')
      --depth;
    else if (next != '!' && next != '?' && text[end - 1] != '/')
      deepest = std::max(deepest, ++depth);
    at = text.find('<', end);
  }
  return deepest;
}

/// Switches off the stack traces of Teuchos for errors of the user.
class NoStackTrace
{
public:
  NoStackTrace() : m_before(Teuchos::TestForException_getEnableStacktrace())
  {
    Teuchos::TestForException_setEnableStacktrace(false);
  }
  ~NoStackTrace() { Teuchos::TestForException_setEnableStacktrace(m_before); }
  NoStackTrace(const NoStackTrace&) = delete;
  NoStackTrace& operator=(const NoStackTrace&) = delete;

private:
  bool m_before;
};

} // namespace

std::string readText(const std::string& file, std::vector<SceneError>& errors)
{
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  const std::string name = "\"" + file + "\" ";
  if (!std::filesystem::exists(status))
    errors.push_back({"", name + "does not exist; give the path of a scene's XML file."});
  else if (std::filesystem::is_directory(status))
    errors.push_back({"", name + "is a folder; give the path of a scene's XML file."});
  else
  {
    std::ifstream in(file, std::ios::binary);
    std::string text;
    if (in && in.peek() == std::ifstream::traits_type::eof())
      errors.push_back({"", name + "is empty; a scene starts with <ParameterList name=\"Rhegma\">."});
    else if (!in)
      errors.push_back({"", name + "can't be read (" + std::strerror(errno) + "); check its permissions."});
    else if (!readUpTo(mostBytes, in, text))
      errors.push_back(
          {"", name + "is larger than 256 MB, which no scene is; give the path of a scene's XML file."});
    else
      return text;
  }
  return {};
}

Teuchos::RCP<Teuchos::ParameterList> parseXml(const std::string& xml, const std::string& topName,
                                              std::vector<SceneError>& errors)
{
  const NoStackTrace quiet;
  const std::string start = "a scene starts with <ParameterList name=\"" + topName + "\">.";
  const std::string byteOrderMark = "\xEF\xBB\xBF";
  const std::string text = xml.rfind(byteOrderMark, 0) == 0 ? xml.substr(byteOrderMark.size()) : xml;
  if (deepestNesting(text) > 100)
  {
    errors.push_back({"", "the tags are nested more than 100 deep, or most are never closed; " + start});
    return Teuchos::null;
  }
  try
  {
    const XMLObject top = Teuchos::StringInputSource(text).getObject();
    if (top.getTag() != "ParameterList")
    {
      errors.push_back({"", "the file starts with <" + top.getTag() + ">; " + start});
      return Teuchos::null;
    }
    const std::string name = top.hasAttribute("name") ? top.getAttribute("name") : "";
    if (name != topName)
    {
      errors.push_back(
          {"", (name.empty() ? "the top list has no name; " : "the top list is \"" + name + "\"; ") + start});
      return Teuchos::null;
    }
    checkAttributes(text, errors);
    const auto list = Teuchos::parameterList(topName);
    Cleaner(errors).list(top, "", *list);
    return list;
  }
  catch (const std::exception& error)
  {
    std::string message = "not well-formed XML: " + parserReason(error.what());
    if (message.find("invalid character in attribute value") != std::string::npos)
      message += " (write &lt; for < and &amp; for &)";
    errors.push_back({"", message + "; " + start});
    return Teuchos::null;
  }
}

} // namespace Rhegma
