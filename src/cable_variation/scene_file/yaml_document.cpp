#include <cable_variation/scene_file/yaml_document.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <yaml-cpp/eventhandler.h>

namespace cable_variation {
namespace {

constexpr std::size_t kDeepest = 32;
constexpr std::size_t kMostValues = 2'000'000;

struct Refusal {
  int line;
  std::string message;
};

int lineAt(const std::string& text, std::size_t position) {
  return 1 + static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(position), '\n'));
}

// Position of the first byte that is not UTF-8 (or is 0), npos if there is none.
std::size_t findNoText(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto first = static_cast<unsigned char>(text[i]);
    const std::size_t length = first < 0x80 ? 1 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first == 0 || (first >= 0x80 && first < 0xc2) || first > 0xf4 || i + length > text.size()) return i;
    for (std::size_t k = 1; k < length; ++k) {
      if ((static_cast<unsigned char>(text[i + k]) & 0xc0U) != 0x80U) return i;
    }
    i += length;
  }
  return std::string::npos;
}

void requireText(const std::string& text) {
  const bool wide = text.compare(0, 2, "\xff\xfe") == 0 || text.compare(0, 2, "\xfe\xff") == 0;
  if (wide) throw Refusal{1, "the file is in UTF-16; expected UTF-8"};
  const std::size_t at = findNoText(text);
  if (at == std::string::npos) return;
  throw Refusal{lineAt(text, at), text[at] == '\0' ? "a byte is 0; expected text"
                                                   : "a character is not in UTF-8, in which scene files are"};
}

/// Watches a text being parsed, and refuses by a throw what a scene cannot be.
class Guard : public YAML::EventHandler {
 public:
  explicit Guard(const std::string& text) : text_(text) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) {
      throw Refusal{mark.line + 1, "a second document starts here ('---'); expected one scene in a file"};
    }
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(mark, {1, 0});
    if (anchor != YAML::NullAnchor) anchors_[anchor] = {1, 0};
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto extent = anchors_.find(anchor);
    if (extent == anchors_.end()) throw Refusal{mark.line + 1, "the alias is within its own anchor"};
    add(mark, extent->second);
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string&) override {
    requireClosed(mark);
    OnNull(mark, anchor);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, anchor);
  }
  void OnMapEnd() override { close(); }

 private:
  // What a place stands for, aliases followed.
  struct Extent {
    std::size_t values;
    std::size_t depth;  // of lists and maps within each other
  };
  struct Open {
    YAML::anchor_t anchor;
    Extent extent;
  };

  // Counts something into the lists and maps around it.
  void add(const YAML::Mark& mark, Extent extent) {
    values_ += extent.values;
    if (values_ > kMostValues) {
      throw Refusal{mark.line + 1, "the file has more than " + std::to_string(kMostValues) +
                                       " values, with what its aliases stand for; expected fewer"};
    }
    if (open_.size() + extent.depth > kDeepest) {
      throw Refusal{mark.line + 1,
                    "lists and maps are nested more than " + std::to_string(kDeepest) + " deep"};
    }
    if (!open_.empty()) count(extent, open_.back().extent);
  }

  static void count(const Extent& inner, Extent& outer) {
    outer.values += inner.values;
    outer.depth = std::max(outer.depth, inner.depth + 1);
  }

  void open(const YAML::Mark& mark, YAML::anchor_t anchor) {
    add(mark, {0, 1});
    ++values_;
    open_.push_back({anchor, {1, 1}});
  }

  void close() {
    const Open last = open_.back();
    open_.pop_back();
    if (last.anchor != YAML::NullAnchor) anchors_[last.anchor] = last.extent;
    if (!open_.empty()) count(last.extent, open_.back().extent);
  }

  // yaml-cpp takes an open quote to go on to the end of the file.
  void requireClosed(const YAML::Mark& mark) const {
    const auto start = static_cast<std::size_t>(mark.pos);
    const char quote = start < text_.size() ? text_[start] : '\0';
    if (quote != '"' && quote != '\'') return;
    for (std::size_t i = start + 1; i < text_.size(); ++i) {
      if (quote == '"' && text_[i] == '\\') {
        ++i;
      } else if (text_[i] == quote) {
        if (quote == '"' || i + 1 >= text_.size() || text_[i + 1] != quote) return;
        ++i;  // '' within '...'
      }
    }
    throw Refusal{mark.line + 1, "not valid YAML: the quote " + std::string(1, quote) + " is not closed"};
  }

  const std::string& text_;
  int documents_ = 0;
  std::size_t values_ = 0;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Extent> anchors_;  // those that are closed
};

// Whether the line of a fault, or that before it, is indented by a tab.
std::string tabHint(const std::string& text, int line) {
  std::istringstream lines(text);
  std::string one;
  for (int number = 1; number <= line && std::getline(lines, one); ++number) {
    const std::size_t first = one.find_first_not_of(" \t");
    const std::size_t tab = one.find('\t');
    if (number >= line - 1 && tab < first && first != std::string::npos) {
      return " (line " + std::to_string(number) + " is indented by a tab; YAML takes blanks)";
    }
  }
  return "";
}

}  // namespace

YAML::Node readYamlDocument(const std::string& original, FaultList& faults) {
  const std::string mark = "\xef\xbb\xbf";
  const std::string text =
      original.compare(0, mark.size(), mark) == 0 ? original.substr(mark.size()) : original;
  try {
    requireText(text);
    std::istringstream stream(text);
    YAML::Parser parser(stream);
    Guard guard(text);
    while (parser.HandleNextDocument(guard)) {
    }
    return YAML::Load(text);
  } catch (const Refusal& refusal) {
    faults.add(refusal.line, refusal.message);
  } catch (const YAML::Exception& error) {
    const int line = error.mark.line + 1;
    faults.add(line, "not valid YAML: " + error.msg + tabHint(text, line));
  }
  return {};
}

}  // namespace cable_variation
