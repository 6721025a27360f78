#pragma once
/// Reads the tags of an XML text one after another.

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Rhegma
{

/// The text is not well-formed XML; the message starts with the line.
class XmlError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/// Tags and texts of an XML document, in their order. No tree is made, so that a document costs no memory
/// beyond its text. Comments, declarations and blanks between tags are left out; document types and CDATA are
/// refused.
class XmlReader
{
public:
  enum class Item
  {
    Opening, ///< a tag that opens an element; one that stands alone is followed by its Closing
    Closing,
    Text, ///< not only blanks
    End
  };

  struct Attribute
  {
    std::string_view name;
    std::string value; ///< references such as &lt; are decoded
  };

  /// \param text must outlive this; it is UTF-8 without byte order mark
  explicit XmlReader(const std::string& text) : text_(text) {}
  explicit XmlReader(std::string&&) = delete;

  /// Goes on to the next item. Throws XmlError.
  Item next();

  /// Name of the opening or closing tag.
  std::string_view tag() const { return tag_; }
  /// Attributes of the opening tag.
  std::size_t numAttributes() const { return numAttributes_; }
  const Attribute& attribute(std::size_t k) const { return attributes_[k]; }
  /// The value of an attribute of the opening tag, or null; of two of the same name that of the last.
  const std::string* find(std::string_view attribute) const;
  /// The text, without blanks at its ends, as it stands.
  std::string_view content() const { return content_; }
  /// Line of the item, counted from 1.
  std::size_t line() const { return lineOf(start_); }
  /// Line of a position in the text.
  std::size_t lineOf(std::size_t at) const;

private:
  struct Open
  {
    std::string_view tag;
    std::size_t at;
  };

  [[noreturn]] void fail(std::size_t at, const std::string& reason) const;
  char at(std::size_t position) const { return position < text_.size() ? text_[position] : '\0'; }
  bool startsWith(std::string_view start) const { return text_.compare(at_, start.size(), start) == 0; }

  bool readText();
  void skipComment();
  void skipDeclaration();
  Item readOpening();
  Item readClosing();
  std::string_view readName();
  void readAttribute();
  void readValue(char quote, std::string& value);
  void readReference(std::string& value);
  bool skipBlanks();

  const std::string& text_;
  std::size_t at_ = 0, start_ = 0;
  std::vector<Open> open_;
  bool closes_ = false; ///< the opening tag stands alone
  bool ended_ = false;  ///< the first element is over
  std::string_view tag_, content_;
  std::vector<Attribute> attributes_; ///< the first ones are those of the tag
  std::size_t numAttributes_ = 0;
};

} // namespace Rhegma
