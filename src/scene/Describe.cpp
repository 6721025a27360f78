#include "base/Numbers.hpp"
#include "scene/NearestName.hpp"
#include "scene/NormaliseValue.hpp"
#include "scene/Scene.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>

namespace Rhegma
{

namespace
{

std::string valueAsText(const ParameterValue& value)
{
  return std::visit(
      [](const auto& v) -> std::string
      {
        using Value = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<Value, bool>)
          return v ? "true" : "false";
        else if constexpr (std::is_same_v<Value, int>)
          return std::to_string(v);
        else if constexpr (std::is_same_v<Value, double>)
          return formatReal(v);
        else if constexpr (std::is_same_v<Value, std::string>)
          return v;
        else
        {
          std::string list;
          for (const auto x : v)
            list += (list.empty() ? "" : ", ") + formatReal(x);
          return "{" + list + "}";
        }
      },
      value);
}

/// The default, or the meaning of its absence.
std::string defaultAsText(const Parameter& parameter)
{
  if (!parameter.derivedDefault.empty())
    return parameter.derivedDefault;
  if (parameter.byDefault && parameter.byDefaultIn3D)
    return valueAsText(*parameter.byDefault) + " in 2D, " + valueAsText(*parameter.byDefaultIn3D) + " in 3D";
  if (parameter.byDefault)
    return valueAsText(*parameter.byDefault);
  return parameter.required ? "required" : "absent";
}

std::string typeName(ParameterType type)
{
  switch (type)
  {
  case ParameterType::Real:
    return "double";
  case ParameterType::Integer:
    return "int";
  case ParameterType::Boolean:
    return "bool";
  case ParameterType::RealArray:
    return "Array(double)";
  case ParameterType::IntegerArray:
    return "Array(int)";
  default:
    return "string";
  }
}

/// Range, choices, length and dimension.
std::string allowedAsText(const Parameter& parameter)
{
  std::vector<std::string> parts;
  const auto add = [&parts](const std::string& part)
  {
    if (!part.empty())
      parts.push_back(part);
  };
  add(parameter.rangeAsText());
  if (!parameter.choices.empty())
    add("one of " + asText(parameter.choices));
  if (parameter.type == ParameterType::RealArray || parameter.type == ParameterType::IntegerArray)
    add(parameter.length.asText(0));
  if (parameter.type == ParameterType::TimeFunction)
    add("an expression of t or a table of time:value");
  if (parameter.mayBeTable)
    add("or a table of temperature:value");
  if (!parameter.mayBeEmpty)
    add("not empty");
  if (parameter.onlyDimension != 0)
    add(std::to_string(parameter.onlyDimension) + "D only");
  if (parameter.changeable)
    add("may change on restart");
  return asText(parts, "; ");
}

std::string ruleAsText(const Together& rule)
{
  switch (rule.rule)
  {
  case Together::Rule::ExactlyOne:
    return "Exactly one of " + asText(rule.names) + " is given.";
  case Together::Rule::AtMostOne:
    return "At most one of " + asText(rule.names) + " is given.";
  case Together::Rule::AllOrNone:
    return asText(rule.names, " and ") + " are given together or not at all.";
  }
  return {};
}

std::string presenceAsText(const Section& section)
{
  return section.presence == Section::Presence::Required ? "required" : "optional";
}

/// Writes a section and all below it; the two forms of the reference override the functions that write one
/// piece.
class Writer
{
public:
  virtual ~Writer() = default;

  void section(const Section& section, const std::string& path, const std::string& note)
  {
    heading(path, note, section.meaning);
    content(section, path);
  }
  std::string text() const { return out.str(); }

protected:
  virtual void heading(const std::string& path, const std::string& note, const std::string& meaning) = 0;
  virtual void table(const std::vector<Parameter>& parameters) = 0;
  virtual void paragraph(const std::string& text) = 0;
  virtual void rules(const std::vector<Rule>& rules) = 0;

  std::ostringstream out;

private:
  void content(const Section& section, const std::string& path)
  {
    if (!section.parameters.empty())
      table(section.parameters);
    for (const auto& rule : section.together)
      paragraph(ruleAsText(rule));
    if (!section.rules.empty())
      rules(section.rules);
    if (section.changeable)
      paragraph("All parameters of this section may change on restart.");
    for (const auto& variant : section.variants)
    {
      const std::string dimension =
          variant.onlyDimension == 0 ? "" : ", " + std::to_string(variant.onlyDimension) + "D only";
      this->section(variant, path, section.key + " = " + variant.name + dimension);
    }
    for (const auto& sub : section.sections)
      this->section(sub, scenePath(path, sub.name), presenceAsText(sub));
    if (section.userNamed())
      this->section(section.entry.front(), scenePath(path, "<" + section.entry.front().name + ">"),
                    "any name, any number");
  }
};

/// For a terminal.
class PlainWriter : public Writer
{
protected:
  void heading(const std::string& path, const std::string& note, const std::string& meaning) override
  {
    out << path << "  (" << note << ")\n    " << meaning << "\n\n";
  }
  void table(const std::vector<Parameter>& parameters) override
  {
    for (const auto& p : parameters)
    {
      out << "  " << p.name << "  " << typeName(p.type) << (p.unit.empty() ? "" : " [" + p.unit + "]");
      const std::string byDefault = defaultAsText(p);
      out << (byDefault == "required" ? "; required"
              : byDefault == "absent" ? "; absent unless given"
                                      : "; default " + byDefault);
      const std::string allowed = allowedAsText(p);
      out << (allowed.empty() ? "" : "; " + allowed) << "\n      " << p.meaning << "\n";
    }
    out << "\n";
  }
  void paragraph(const std::string& text) override { out << "  " << text << "\n\n"; }
  void rules(const std::vector<Rule>& rules) override
  {
    out << "  Rejected combinations:\n";
    for (const Rule& rule : rules)
      out << "    " << rule.asText() << ":\n      " << rule.reason << "\n";
    out << "\n";
  }

public:
  /// Parameters of a section alone.
  void parameters(const std::string& path, const std::vector<Parameter>& some)
  {
    out << path << "\n\n";
    table(some);
  }
};

/// The names in a path such as "Thermal > Sources" or, as for --set, "Thermal:Sources".
std::vector<std::string> partsOf(std::string path)
{
  for (std::size_t at = 0; (at = path.find(" > ", at)) != std::string::npos;)
    path.replace(at, 3, ":");
  std::vector<std::string> parts;
  std::istringstream names(path);
  for (std::string name; std::getline(names, name, ':');)
    parts.push_back(name);
  return parts;
}

/// The subsections with fixed names, those of variants too.
std::vector<const Section*> subsections(const Section& section)
{
  std::vector<const Section*> all;
  for (const auto& sub : section.sections)
    all.push_back(&sub);
  for (const auto& variant : section.variants)
    for (const Section* sub : subsections(variant))
      all.push_back(sub);
  return all;
}

/// The parameters, those of variants too.
std::vector<Parameter> parametersOf(const Section& section)
{
  std::vector<Parameter> all = section.parameters;
  for (const auto& variant : section.variants)
    for (const auto& p : parametersOf(variant))
      all.push_back(p);
  return all;
}

/// The section or parameter at a path; user-defined names may be any.
/// \throws std::invalid_argument where there is none
void describePart(const Section& root, const std::vector<std::string>& names, PlainWriter& writer)
{
  const Section* section = &root;
  std::string path, note;
  for (const std::string& name : names)
  {
    std::vector<std::string> known;
    const Section* next = nullptr;
    for (const Section* sub : subsections(*section))
    {
      known.push_back(sub->name);
      next = sub->name == name ? sub : next;
    }
    std::vector<Parameter> named;
    for (const auto& p : parametersOf(*section))
    {
      known.push_back(p.name);
      const auto same = [&p](const Parameter& q)
      { return q.meaning == p.meaning && q.unit == p.unit && q.required == p.required; };
      if (p.name == name && std::none_of(named.begin(), named.end(), same)) // variants may have a common one
        named.push_back(p);
    }
    if (next == nullptr && !named.empty())
    {
      if (&name != &names.back())
        throw std::invalid_argument(scenePath(path, name) + " is a parameter, which has no parts");
      writer.parameters(scenePath(path, name), named);
      return;
    }
    note = next != nullptr ? presenceAsText(*next) : "any name, any number";
    if (next == nullptr && section->userNamed())
      next = &section->entry.front();
    if (next == nullptr)
      throw std::invalid_argument((path.empty() ? "there is no section \"" : "there is no \"") +
                                  scenePath(path, name) + "\"; " + suggestion(name, known));
    section = next;
    path = scenePath(path, name);
  }
  writer.section(*section, path, note);
}

/// Adds the paths of all sections and parameters with a name. \param name in lower case
void findNamed(const Section& section, const std::string& path, const std::string& name,
               std::vector<std::string>& found)
{
  const auto add = [&](const std::string& own)
  {
    const std::string whole = scenePath(path, own);
    if (lowerCase(own) == name && std::find(found.begin(), found.end(), whole) == found.end())
      found.push_back(whole);
  };
  for (const Parameter& p : parametersOf(section))
    add(p.name);
  for (const Section* sub : subsections(section))
  {
    add(sub->name);
    findNamed(*sub, scenePath(path, sub->name), name, found);
  }
  for (const Section& entry : section.entry)
    findNamed(entry, scenePath(path, "<" + entry.name + ">"), name, found);
}

/// A cell of a Markdown table.
std::string cell(const std::string& text)
{
  std::string escaped;
  for (const char c : text)
    escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

/// The anchor of a heading.
std::string anchor(const std::string& heading)
{
  std::string link;
  for (const char c : lowerCase(heading))
    link += c == ' ' ? '-' : c;
  return link;
}

class MarkdownWriter : public Writer
{
protected:
  void heading(const std::string& path, const std::string& note, const std::string& meaning) override
  {
    const bool top = path.find(" > ") == std::string::npos;
    std::string safe;
    for (const char c : path)
      safe += c == '<' ? std::string("\\<") : std::string(1, c);
    out << (top && note.find(" = ") == std::string::npos ? "## " : "### ") << safe
        << (note.find(" = ") == std::string::npos ? "" : ", " + note) << "\n\n";
    if (note.find(" = ") == std::string::npos)
      out << "(" << note << ") ";
    out << meaning << "\n\n";
  }
  void table(const std::vector<Parameter>& parameters) override
  {
    out << "| Parameter | Type | Unit | Default | Allowed | Meaning |\n|:--|:--|:--|:--|:--|:--|\n";
    for (const auto& p : parameters)
      out << "| " << p.name << " | " << typeName(p.type) << " | " << cell(p.unit) << " | "
          << cell(defaultAsText(p)) << " | " << cell(allowedAsText(p)) << " | " << cell(p.meaning) << " |\n";
    out << "\n";
  }
  void paragraph(const std::string& text) override { out << text << "\n\n"; }
  void rules(const std::vector<Rule>& rules) override
  {
    out << "| Rejected combination | Reason, and what to do |\n|:--|:--|\n";
    for (const Rule& rule : rules)
      out << "| " << cell(rule.asText()) << " | " << cell(rule.reason) << " |\n";
    out << "\n";
  }
};

} // namespace

std::string describe(const SceneSchema& schema, const std::string& path)
{
  PlainWriter writer;
  if (path.empty())
    for (const auto& s : schema.root().sections)
      writer.section(s, s.name, presenceAsText(s));
  else
  {
    // A name that is no section's may be that of parts anywhere.
    const std::vector<std::string> parts = partsOf(path);
    const auto& top = schema.root().sections;
    std::vector<std::string> found;
    if (parts.size() == 1 &&
        std::none_of(top.begin(), top.end(), [&](const Section& s) { return s.name == parts[0]; }))
      findNamed(schema.root(), "", lowerCase(parts[0]), found);
    if (found.empty())
      found.push_back(path);
    for (const std::string& one : found)
      describePart(schema.root(), partsOf(one), writer);
  }
  return writer.text();
}

std::string describeMarkdown(const SceneSchema& schema)
{
  MarkdownWriter writer;
  std::string contents;
  for (const auto& s : schema.root().sections)
  {
    writer.section(s, s.name, presenceAsText(s));
    contents += (contents.empty() ? "" : ", ") + ("[" + s.name + "](#" + anchor(s.name) + ")");
  }
  std::string text = writer.text();
  while (text.size() > 1 && text.substr(text.size() - 2) == "\n\n")
    text.pop_back();
  return "# Parameters of a scene\n\n"
         "Printed by the program (`rhegma --describe-markdown`) from the descriptions that validate "
         "scenes.\n\n"
         "A scene is a Teuchos parameter list `Rhegma` with these sections: " +
         contents +
         ".\nA name in angle brackets is chosen by you. Numbers are in the units of the tables, unless "
         "a unit\nis given (`unit=\"mm\"`, [how](how-to/units.md)). A time function is a string: an "
         "expression\nof t [s], such as `100*sin(2000*t)`, or a table of time:value, such as "
         "`0:0, 1e-3:100`.\n\n" +
         text;
}

} // namespace Rhegma
