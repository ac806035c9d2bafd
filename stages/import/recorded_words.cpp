#include "stages/import/recorded_words.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>

namespace morphe::imports {
namespace {

using Words = std::vector<BodyWord>;

const std::map<std::string, Words, std::less<>>& dictionary() {
  using enum BodyWord;
  static const std::map<std::string, Words, std::less<>> words = {
      {"l", {left}},
      {"left", {left}},
      {"lt", {left}},
      {"lft", {left}},
      {"links", {left}},
      {"linke", {left}},
      {"linker", {left}},
      {"gauche", {left}},
      {"r", {right}},
      {"right", {right}},
      {"rt", {right}},
      {"rgt", {right}},
      {"rechts", {right}},
      {"rechte", {right}},
      {"rechter", {right}},
      {"droit", {right}},
      {"droite", {right}},
      {"upper", {upper}},
      {"up", {upper}},
      {"lower", {lower}},
      {"low", {lower}},
      {"lo", {lower}},
      {"fore", {lower}},
      {"arm", {arm}},
      {"bras", {arm}},
      {"humerus", {upper_arm}},
      {"hum", {upper_arm}},
      {"upa", {upper_arm}},
      {"uar", {upper_arm}},
      {"ua", {upper_arm}},
      {"oberarm", {upper_arm}},
      {"frm", {forearm}},
      {"lar", {forearm}},
      {"fa", {forearm}},
      {"unterarm", {forearm}},
      {"avantbras", {forearm}},
      {"leg", {leg}},
      {"thigh", {thigh}},
      {"femur", {thigh}},
      {"shin", {shin}},
      {"shank", {shin}},
      {"calf", {shin}},
      {"tibia", {shin}},
      {"shoulder", {shoulder}},
      {"shldr", {shoulder}},
      {"should", {shoulder}},
      {"sho", {shoulder}},
      {"acromion", {shoulder}},
      {"acrom", {shoulder}},
      {"acr", {shoulder}},
      {"acro", {shoulder}},
      {"gh", {shoulder}},
      {"glenohumeral", {shoulder}},
      {"schulter", {shoulder}},
      {"epaule", {shoulder}},
      {"scapula", {scapula}},
      {"scap", {scapula}},
      {"clavicle", {clavicle}},
      {"clav", {clavicle}},
      {"collar", {clavicle}},
      {"elbow", {elbow}},
      {"elb", {elbow}},
      {"ellbogen", {elbow}},
      {"ellenbogen", {elbow}},
      {"coude", {elbow}},
      {"epicondyle", {epicondyle}},
      {"epicond", {epicondyle}},
      {"epic", {epicondyle}},
      {"condyle", {epicondyle}},
      {"lateral", {lateral}},
      {"lat", {lateral}},
      {"outer", {lateral}},
      {"outside", {lateral}},
      {"medial", {medial}},
      {"med", {medial}},
      {"inner", {medial}},
      {"inside", {medial}},
      {"wrist", {wrist}},
      {"wri", {wrist}},
      {"wr", {wrist}},
      {"handgelenk", {wrist}},
      {"poignet", {wrist}},
      // Plug-in Gait, and the landmarks of the calibrated anatomical systems technique.
      {"wra", {wrist, radial}},
      {"wrb", {wrist, ulnar}},
      {"fin", {index, mcp}},
      {"upb", {upper_arm}},
      {"upc", {upper_arm}},
      {"hle", {epicondyle, lateral}},
      {"hme", {epicondyle, medial}},
      {"rsp", {styloid, radial}},
      {"usp", {styloid, ulnar}},
      {"sae", {shoulder}},
      {"styloid", {styloid}},
      {"styl", {styloid}},
      {"radial", {radial}},
      {"radius", {radial}},
      {"rad", {radial}},
      {"ulnar", {ulnar}},
      {"ulna", {ulnar}},
      {"uln", {ulnar}},
      {"hand", {hand}},
      {"palm", {hand}},
      {"glove", {hand}},
      {"finger", {finger}},
      {"fing", {finger}},

      {"digit", {finger}},
      {"thumb", {thumb}},
      {"thm", {thumb}},
      {"thum", {thumb}},
      {"pollex", {thumb}},
      {"daumen", {thumb}},
      {"pouce", {thumb}},
      {"index", {index}},
      {"indx", {index}},
      {"idx", {index}},
      {"ind", {index}},
      {"forefinger", {index}},
      {"pointer", {index}},
      {"zeigefinger", {index}},
      {"middle", {middle}},
      {"mid", {middle}},
      {"mittelfinger", {middle}},
      {"majeur", {middle}},
      {"ring", {ring}},
      {"rng", {ring}},
      {"ringfinger", {ring}},
      {"annulaire", {ring}},
      {"little", {little}},
      {"pinky", {little}},
      {"pinkie", {little}},
      {"pink", {little}},
      {"small", {little}},
      {"kleinfinger", {little}},
      {"auriculaire", {little}},
      {"tip", {tip}},
      {"end", {tip}},
      {"nail", {tip}},
      {"nub", {tip}},
      {"fingertip", {finger, tip}},
      {"spitze", {tip}},
      {"mcp", {mcp}},
      {"knuckle", {mcp}},
      {"base", {mcp}},
      {"pip", {pip}},
      {"dip", {dip}},
      {"ip", {ip}},
      {"cmc", {cmc}},
      {"proximal", {proximal}},
      {"prox", {proximal}},
      {"intermediate", {intermediate}},
      {"inter", {intermediate}},
      {"distal", {distal}},
      {"dist", {distal}},
      {"metacarpal", {metacarpal}},
      {"meta", {metacarpal}},
      {"carpal", {metacarpal}},
      {"hip", {hip}},
      {"hanche", {hip}},
      {"asis", {hip}},
      {"pelvis", {pelvis}},
      {"hips", {pelvis}},
      {"sacrum", {pelvis}},
      {"becken", {pelvis}},
      {"head", {head}},
      {"kopf", {head}},
      {"tete", {head}},
      {"forehead", {head}},
      {"neck", {neck}},
      {"spine", {trunk}},
      {"chest", {trunk}},
      {"thorax", {trunk}},
      {"sternum", {trunk}},
      {"trunk", {trunk}},
      {"torso", {trunk}},
      {"back", {trunk}},
      {"knee", {knee}},
      {"ankle", {ankle}},
      {"foot", {foot}},
      {"heel", {foot}},
      {"toe", {toe}},
      {"twist", {twist}},
      {"roll", {twist}},
      {"share", {twist}},
      {"bone", {filler}},
      {"joint", {filler}},
      {"jnt", {filler}},
      {"marker", {filler}},
      {"mrk", {filler}},
      {"point", {filler}},
      {"bip", {filler}},
      {"cc", {filler}},
      {"def", {filler}},
      {"f", {filler}},
      {"centre", {filler}},
      {"center", {filler}},
      {"jc", {filler}},
      {"pos", {filler}},
      {"position", {filler}},
      {"de", {filler}},
      {"du", {filler}},
      {"of", {filler}},
      {"the", {filler}},
      {"cluster", {filler}},
      {"cl", {filler}},
      {"plate", {filler}},
      {"landmark", {filler}},
      {"mixamorig", {filler}}};
  return words;
}

/// Letters as a sequence of words, as few as can be; nothing if they are none.
std::optional<Words> split(std::string_view letters) {
  constexpr std::size_t kLongest = 24;  // of any name that is worth it
  if (letters.size() > kLongest) return std::nullopt;
  if (const auto found = dictionary().find(letters); found != dictionary().end()) {
    return found->second;
  }
  std::optional<Words> best;
  for (std::size_t length = 1; length < letters.size(); ++length) {
    const auto found = dictionary().find(letters.substr(0, length));
    if (found == dictionary().end()) continue;
    std::optional<Words> rest = split(letters.substr(length));
    if (!rest || (best && best->size() <= rest->size() + found->second.size())) continue;
    rest->insert(rest->begin(), found->second.begin(), found->second.end());
    best = std::move(rest);
  }
  return best;
}

enum class Kind { sign, digit, small, capital };

Kind kind_of(char c) {
  const auto u = static_cast<unsigned char>(c);
  if (std::isdigit(u)) return Kind::digit;
  if (std::isupper(u)) return Kind::capital;
  return std::islower(u) || u >= 0x80 ? Kind::small : Kind::sign;
}

/// "RightHandIndex3_end" at changes of kind; a capital belongs to the small letters behind it.
std::vector<std::string> pieces_of(std::string_view name) {
  std::vector<std::string> pieces(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const Kind now = kind_of(name[i]), before = i > 0 ? kind_of(name[i - 1]) : Kind::sign;
    const bool word_begins = now == Kind::capital && before == Kind::capital &&
                             i + 2 < name.size() && kind_of(name[i + 1]) == Kind::small &&
                             kind_of(name[i + 2]) == Kind::small;
    const bool goes_on = now == before || (now == Kind::small && before == Kind::capital);
    if (!goes_on || word_begins) pieces.emplace_back();
    if (now != Kind::sign) {
      pieces.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
    }
  }
  std::erase(pieces, "");
  return pieces;
}

}  // namespace

bool RecordedWords::has(BodyWord word) const {
  return std::ranges::find(words, word) != words.end();
}

RecordedWords recorded_words_of(std::string_view name) {
  if (const std::size_t colon = name.rfind(':'); colon + 1 < name.size()) {
    name.remove_prefix(colon + 1);
  }
  RecordedWords result;
  for (const std::string& piece : pieces_of(name)) {
    if (kind_of(piece[0]) == Kind::digit) {
      result.numbers.push_back(piece.size() < 7 ? std::stoi(piece) : 0);
      continue;
    }
    const std::optional<Words> words = split(piece);
    if (words) {
      result.words.insert(result.words.end(), words->begin(), words->end());
    } else {
      result.strange = true;
    }
  }
  return result;
}

}  // namespace morphe::imports
