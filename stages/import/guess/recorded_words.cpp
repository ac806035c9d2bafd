#include "stages/import/guess/recorded_words.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <sstream>

namespace morphe::imports {
namespace {

using Message = std::vector<BodyWord>;

/// The spellings of a word or a sequence of words.
struct Spelling {
  Message words;
  std::string_view spellings;  ///< separated by blanks
};

const std::vector<Spelling>& spelling_table() {
  using enum BodyWord;
  static const std::vector<Spelling> all = {
      {{left},
       "l left lt lft links linke linker gauche izquierda izquierdo sinistra "
       "sinistro 左"},
      {{right},
       "r right rt rgt rechts rechte rechter droit droite derecha derecho "
       "destra destro 右"},
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
      {{epicondyle}, "epicondyle epicond epic condyle"},
      {{lateral}, "lateral lat outer outside"},
      {{medial}, "medial med inner inside"},
      {{wrist}, "wrist wri wr handgelenk poignet muneca muñeca polso pulso pols 手首 手腕"},
      {{wrist, radial}, "wra"},
      {{wrist, ulnar}, "wrb"},
      {{index, mcp}, "fin"},
      {{epicondyle, lateral}, "hle"},
      {{epicondyle, medial}, "hme"},
      {{styloid, radial}, "rsp"},
      {{styloid, ulnar}, "usp"},
      {{styloid}, "styloid styl"},
      {{radial}, "radial radius rad"},
      {{ulnar}, "ulnar ulna uln"},
      {{hand}, "hand palm glove mano 手"},
      {{finger}, "finger fing digit"},
      {{thumb},
       "thumb thm thum pollex daumen pouce pulgar pollice polegar duim 親指 拇指 "
       "大拇指"},
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
      {{twist}, "twist roll share"},
      {{filler},
       "bone joint jnt marker mrk point bip cc def f centre center jc pos "
       "position de du of the cluster cl plate landmark mixamorig ０ １ ２ ３ ４"},
  };
  return all;
}

const std::map<std::string, Message, std::less<>>& dictionary() {
  static const auto words = [] {
    std::map<std::string, Message, std::less<>> by_spelling;
    for (const Spelling& one : spelling_table()) {
      std::istringstream spellings{std::string(one.spellings)};
      for (std::string word; spellings >> word;) by_spelling[word] = one.words;
    }
    return by_spelling;
  }();
  return words;
}

/// Splits letters into as few words as possible; returns no value if that is impossible.
std::optional<Message> split(std::string_view letters) {
  constexpr std::size_t kMaxNameLength = 24;  // longer names are not split
  if (letters.size() > kMaxNameLength) return std::nullopt;
  if (const auto found = dictionary().find(letters); found != dictionary().end()) {
    return found->second;
  }
  std::optional<Message> best;
  for (std::size_t length = 1; length < letters.size(); ++length) {
    const auto found = dictionary().find(letters.substr(0, length));
    if (found == dictionary().end()) continue;
    std::optional<Message> rest = split(letters.substr(length));
    if (!rest || (best && best->size() <= rest->size() + found->second.size())) continue;
    rest->insert(rest->begin(), found->second.begin(), found->second.end());
    best = std::move(rest);
  }
  return best;
}

enum class CharKind { sign, digit, small, capital };

CharKind kind_of(char c) {
  const auto u = static_cast<unsigned char>(c);
  if (std::isdigit(u)) return CharKind::digit;
  if (std::isupper(u)) return CharKind::capital;
  return std::islower(u) || u >= 0x80 ? CharKind::small : CharKind::sign;
}

/// Splits a name such as "RightHandIndex3_end" at changes of character class; a capital belongs to
/// the small letters after it.
std::vector<std::string> pieces_of(std::string_view name) {
  std::vector<std::string> pieces(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const CharKind now = kind_of(name[i]), before = i > 0 ? kind_of(name[i - 1]) : CharKind::sign;
    const bool word_begins = now == CharKind::capital && before == CharKind::capital &&
                             i + 2 < name.size() && kind_of(name[i + 1]) == CharKind::small &&
                             kind_of(name[i + 2]) == CharKind::small;
    const bool goes_on = now == before || (now == CharKind::small && before == CharKind::capital);
    if (!goes_on || word_begins) pieces.emplace_back();
    if (now != CharKind::sign) {
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

RecordedWords parse_recorded_name(std::string_view name) {
  if (const std::size_t colon = name.rfind(':'); colon + 1 < name.size()) {
    name.remove_prefix(colon + 1);
  }
  RecordedWords result;
  for (const std::string& piece : pieces_of(name)) {
    if (kind_of(piece[0]) == CharKind::digit) {
      result.numbers.push_back(piece.size() < 7 ? std::stoi(piece) : 0);
      continue;
    }
    const std::optional<Message> words = split(piece);
    if (words) {
      result.words.insert(result.words.end(), words->begin(), words->end());
    } else {
      result.has_unknown_word = true;
    }
  }
  return result;
}

}  // namespace morphe::imports
