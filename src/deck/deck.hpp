// A deck file: its options, and where in the text each of them stands, so that every later error can point there.
#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "deck/options.hpp"

namespace mortise {

class DeckSource;

/// A deck that has been read and checked on its own (meshes are not opened yet).
class Deck {
 public:
  /// @throws DeckError with every error found (unknown, repeated, misspelt, missing, wrong type, out of bounds);
  ///         FileError when the file cannot be read
  static Deck read(const std::filesystem::path& file);

  /// The same from text. @param file the name used in messages, and the folder that paths are relative to
  static Deck from_text(const std::filesystem::path& file, std::string text);

  const DeckOptions& options() const { return options_; }
  const std::filesystem::path& file() const { return file_; }

  /// The text of the deck as read; its hash goes into the manifest.
  const std::string& text() const;

  /// A message at the place of a list or parameter: `file:line:col: error[code] a > b > "name" = value - what`.
  /// @param path e.g. {"contact", "indenter on slab", "secondary"}; the nearest existing ancestor gives the position
  std::string error(const std::string& code, const std::vector<std::string>& path, const std::string& what) const;

 private:
  static Deck from_source(const std::filesystem::path& file, std::shared_ptr<const DeckSource> source);
  Deck(std::filesystem::path file, std::shared_ptr<const DeckSource> source, DeckOptions options);
  std::filesystem::path file_;
  std::shared_ptr<const DeckSource> source_;
  DeckOptions options_;
};

/// Reads the recipe file of `mortise mesh`: a ParameterList with the parameters of one entry of `meshes`.
/// @throws as Deck::read
MeshOptions read_recipe(const std::filesystem::path& file);

/// Prints the deck reference made from the descriptions the reader uses: everything, or one list (e.g. "contact").
/// @throws UserError (exit code 1) for an unknown list, with the nearest known name
void print_reference(std::ostream& out, const std::string& list = "");

/// Prints the RELAX NG schema (XML syntax) of decks and recipes, made from the same descriptions: names, types, words to choose
/// from. Bounds, and what is required, repeated or tied together, only the reader checks.
void print_schema(std::ostream& out);

}  // namespace mortise
