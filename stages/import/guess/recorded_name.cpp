#include "stages/import/guess/recorded_name.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <sstream>

#include "stages/import/guess/constants.hpp"
#include "stages/import/recording/name_sides.hpp"
#include "stages/import/recording/name_words.hpp"

namespace morphe::imports {
namespace {

using BodyTerms = std::vector<BodyTerm>;

/// The words that mean a sequence of terms.
struct KnownWords {
  BodyTerms terms;         ///< usually one
  std::string_view words;  ///< separated by blanks, in small letters
};

const std::vector<KnownWords>& known_words() {
  using enum BodyTerm;
  static const std::vector<KnownWords> all = {
      {{left}, "l"},
      {{right}, "r"},
      {{upper}, "upper up"},
      {{lower}, "lower low lo fore"},
      {{arm}, "arm bras"},
      {{upper_arm}, "humerus hum upa uar ua oberarm upb upc 腕 上臂 biceps bicep"},
      {{forearm}, "frm lar fa unterarm avantbras antebrazo avambraccio 前臂"},
      {{leg}, "leg"},
      {{thigh}, "thigh femur"},
      {{shin}, "shin shank calf tibia"},
      {{shoulder},
       "shoulder shldr should sho acromion acrom acr acro gh glenohumeral "
       "schulter epaule sae épaule hombro spalla ombro schouder 肩"},
      {{scapula}, "scapula scap"},
      {{clavicle}, "clavicle clav collar"},
      {{elbow}, "elbow elb ellbogen ellenbogen coude codo gomito cotovelo elleboog ひじ 肘"},
      {{epicondyle}, "epicondyle epicond epic ep condyle"},
      {{lateral}, "lateral lat outer outside"},
      {{medial}, "medial med inner inside"},
      {{wrist}, "wrist wri wr handgelenk poignet muneca muñeca polso pulso pols 手首 手腕"},
      {{wrist, radial}, "wra"},
      {{wrist, ulnar}, "wrb"},
      {{index, mcp}, "fin"},
      {{epicondyle, lateral}, "hle"},
      {{epicondyle, medial}, "hme"},
      {{styloid, radial}, "rsp rs"},
      {{styloid, ulnar}, "usp us"},
      {{styloid}, "styloid styl"},
      {{radial}, "radial radius rad"},
      {{ulnar}, "ulnar ulna uln"},
      {{hand}, "hand palm glove mano 手"},
      {{finger}, "finger fing digit"},
      {{thumb}, "thumb thm thum pollex daumen pouce pulgar pollice polegar duim 親指 拇指 大拇指"},
      {{index},
       "index indx idx ind forefinger pointer zeigefinger indice índice "
       "wijsvinger 人指 人差指 人差し指 食指"},
      {{middle}, "middle mid mittelfinger majeur medio 中指"},
      {{ring}, "ring rng ringfinger annulaire anular anulare 薬指 无名指"},
      {{little},
       "little pinky pinkie pink small kleinfinger auriculaire mignolo menique "
       "meñique 小指 小拇指"},
      {{tip}, "tip end nail nub spitze 先 punta"},
      {{finger, tip}, "fingertip"},
      {{mcp}, "mcp knuckle base"},
      {{pip}, "pip"},
      {{dip}, "dip"},
      {{ip}, "ip"},
      {{cmc}, "cmc"},
      {{proximal}, "proximal prox"},
      {{intermediate}, "intermediate inter"},
      {{distal}, "distal dist"},
      {{metacarpal}, "metacarpal meta carpal"},
      {{hip}, "hip hanche asis"},
      {{pelvis}, "pelvis hips sacrum becken"},
      {{head}, "head kopf tete forehead 頭 头 cabeza testa"},
      {{neck}, "neck"},
      {{trunk}, "spine chest thorax sternum trunk torso back"},
      {{knee}, "knee"},
      {{ankle}, "ankle"},
      {{foot}, "foot heel"},
      {{toe}, "toe"},
      {{ankle}, "fal tam malleolus"},  // of the set of the Istituto Ortopedico Rizzoli
      {{knee}, "fle fme fax ttc"},     // the same
      {{foot}, "fcc"},                 // the same
      {{pelvis}, "ias ips"},           // the same
      {{twist}, "twist roll share"},
      {{quantity},
       "angle angles moment moments power powers force forces torque torques velocity velocities "
       "acceleration speed"},
      {{filler},
       "bone joint jnt marker mrk point bip cc def f centre center jc pos "
       "position de du of the cluster cl plate landmark mixamorig ０ １ ２ ３ ４"},
  };
  return all;
}

const std::map<std::string, BodyTerms, std::less<>>& terms_by_word() {
  static const auto dictionary = [] {
    std::map<std::string, BodyTerms, std::less<>> terms;
    for (const KnownWords& entry : known_words()) {
      std::istringstream words{std::string(entry.words)};
      for (std::string word; words >> word;) terms[word] = entry.terms;
    }
    for (const Side side : {Side::left, Side::right}) {
      for (const std::string_view word : side_words(side))
        terms[std::string(word)] = {side == Side::left ? BodyTerm::left : BodyTerm::right};
    }
    return terms;
  }();
  return dictionary;
}

/// Returns the terms of the known words into which the letters can be split completely; of several
/// splits the one with the fewest terms. No value if there is no such split, or for too many bytes.
std::optional<BodyTerms> terms_in(std::string_view letters) {
  if (letters.size() > kMaxSplitBytes) return std::nullopt;
  if (const auto whole = terms_by_word().find(letters); whole != terms_by_word().end())
    return whole->second;
  std::optional<BodyTerms> fewest;
  for (std::size_t length = 1; length < letters.size(); ++length) {
    const auto first = terms_by_word().find(letters.substr(0, length));
    if (first == terms_by_word().end()) continue;
    std::optional<BodyTerms> terms = terms_in(letters.substr(length));
    if (!terms || (fewest && fewest->size() <= terms->size() + first->second.size())) continue;
    terms->insert(terms->begin(), first->second.begin(), first->second.end());
    fewest = std::move(terms);
  }
  return fewest;
}

bool contains_side(const BodyTerms& terms) {
  return std::ranges::any_of(
      terms, [](BodyTerm term) { return term == BodyTerm::left || term == BodyTerm::right; });
}

/// Splits a name into runs of letters and runs of digits, in small letters. A capital begins a new
/// piece after a small letter; after a capital only if two small letters follow. "RightHand3_end"
/// is right hand 3 end, "RElbow" is r elbow, and "MCPs" is one piece.
std::vector<std::string> split_into_pieces(std::string_view name) {
  std::vector<std::string> pieces(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const CharClass kind = char_class(name[i]),
                    before = i > 0 ? char_class(name[i - 1]) : CharClass::other;
    const bool capital_begins =
        kind == CharClass::capital && before == CharClass::capital && i + 2 < name.size() &&
        char_class(name[i + 1]) == CharClass::small && char_class(name[i + 2]) == CharClass::small;
    const bool continues =
        kind == before || (kind == CharClass::small && before == CharClass::capital);
    if (!continues || capital_begins) pieces.emplace_back();
    if (kind != CharClass::other)
      pieces.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(name[i])));
  }
  std::erase(pieces, "");
  return pieces;
}

}  // namespace

RecordedName parse_recorded_name(std::string_view name) {
  if (const std::size_t colon = name.rfind(':'); colon + 1 < name.size())  // npos + 1 is 0
    name.remove_prefix(colon + 1);
  RecordedName result;
  const std::vector<std::string> pieces = split_into_pieces(name);
  const bool has_side = std::ranges::any_of(pieces, [](const std::string& piece) {
    const auto known = terms_by_word().find(piece);
    return known != terms_by_word().end() && contains_side(known->second);
  });
  for (const std::string& piece : pieces) {
    if (char_class(piece[0]) == CharClass::digit) {
      result.numbers.push_back(piece.size() <= kMaxDigits ? std::stoi(piece) : 0);
      continue;
    }
    const std::optional<BodyTerms> terms = terms_in(piece);
    // In R_FAL, FAL does not contain a second side.
    if (terms && !(has_side && terms->size() > 1 && contains_side(*terms))) {
      result.terms.insert(result.terms.end(), terms->begin(), terms->end());
    } else {
      result.has_unknown_word = true;
    }
  }
  return result;
}

}  // namespace morphe::imports
