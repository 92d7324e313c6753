// Reads a deck: text, tree, options by the descriptions, checks between lists; all errors in the order of the deck.
#include "deck/deck.hpp"

#include <algorithm>
#include <tuple>

#include "deck/cross_checks.hpp"
#include "deck/descriptions.hpp"
#include "deck/reader.hpp"
#include "deck/source.hpp"
#include "deck/stages.hpp"
#include "errors.hpp"

namespace mortise {

namespace {

/// A recipe file holds what one entry of `meshes` holds, except a file.
struct RecipeFile {
  MeshOptions mesh;
};

template <class Fields>
void describe(Fields& f, RecipeFile& o) {
  describe_recipe(f, o.mesh, Presence::required);
}

void throw_if_any(std::vector<DeckProblem> problems) {
  if (problems.empty()) return;
  std::stable_sort(problems.begin(), problems.end(), [](const DeckProblem& a, const DeckProblem& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  std::vector<std::string> messages;
  for (const DeckProblem& one : problems) messages.push_back(one.text);
  throw DeckError(messages);
}

}  // namespace

Deck Deck::read(const std::filesystem::path& file) {
  return from_source(file, std::make_shared<const DeckSource>(DeckSource::read(file)));
}

Deck Deck::from_text(const std::filesystem::path& file, std::string text) {
  return from_source(file, std::make_shared<const DeckSource>(file, std::move(text)));
}

Deck Deck::from_source(const std::filesystem::path& file, std::shared_ptr<const DeckSource> source) {
  Findings findings;
  findings.problems = source->problems();
  DeckOptions options;
  Reader::read_list(*source, source->root(), {}, options, findings);
  check_across(*source, options, findings);
  throw_if_any(findings.problems);
  set_pauses(options);
  return Deck(file, source, std::move(options));
}

Deck::Deck(std::filesystem::path file, std::shared_ptr<const DeckSource> source, DeckOptions options)
    : file_(std::move(file)), source_(std::move(source)), options_(std::move(options)) {}

const std::string& Deck::text() const { return source_->text(); }

std::string Deck::error(const std::string& code, const std::vector<std::string>& path, const std::string& what) const {
  return source_->problem(code, path, what).text;
}

MeshOptions read_recipe(const std::filesystem::path& file) {
  const DeckSource source = DeckSource::read(file);
  Findings findings;
  findings.problems = source.problems();
  RecipeFile recipe;
  Reader::read_list(source, source.root(), {}, recipe, findings);
  throw_if_any(findings.problems);
  return recipe.mesh;
}

}  // namespace mortise
