#include "core/simulation/spoken_instruction.h"

#include <array>
#include <cctype>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

namespace farol::simulation {

using guidance::SweepStep;
using routing::Side;
using routing::Vertical;

namespace {

bool begins(std::string_view text, std::string_view with) {
    return text.substr(0, with.size()) == with;
}

bool has(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// Takes the words off the front, if they are there.
bool take(std::string_view& text, std::string_view words) {
    if (!begins(text, words)) return false;
    text.remove_prefix(words.size());
    return true;
}

/// Cut where a stop is followed by a space: "2.23" stays whole.
std::vector<std::string> sentencesOf(const std::string& words) {
    std::vector<std::string> sentences;
    std::string one;
    for (std::size_t i = 0; i < words.size(); ++i) {
        bool ends = words[i] == '.' && (i + 1 == words.size() || words[i + 1] == ' ');
        if (!ends) {
            if (!one.empty() || words[i] != ' ') one += words[i];
            continue;
        }
        sentences.push_back(std::exchange(one, {}));
    }
    if (!one.empty()) sentences.push_back(one);
    return sentences;
}

std::string inLowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return lower;
}

/// "turn left", "turning sharply left", "go straight on".
std::optional<Radians> turnIn(std::string_view text) {
    struct Word {
        std::string_view words;
        double degrees;
    };
    constexpr std::array<Word, 8> kWords{{{" slightly left", 45.0},
                                          {" slightly right", -45.0},
                                          {" sharply left", 135.0},
                                          {" sharply right", -135.0},
                                          {" left", 90.0},
                                          {" right", -90.0},
                                          {" around", 180.0},
                                          {"", 0.0}}};
    if (begins(text, "go straight on") && !has(text, "through")) return fromDegrees(0.0);
    if (!take(text, "turning") && !take(text, "turn")) return std::nullopt;
    for (const Word& word : kWords)
        if (text == word.words) return fromDegrees(word.degrees);
    return std::nullopt;
}

int ordinalIn(std::string_view text) {
    constexpr std::array<std::string_view, 8> kWords{"first ", "second ", "third ",   "fourth ",
                                                     "fifth ", "sixth ",  "seventh ", "eighth "};
    if (has(text, "the next ")) return 1;
    for (std::size_t i = 0; i < kWords.size(); ++i)
        if (has(text, kWords[i])) return static_cast<int>(i) + 1;
    return 0;
}

/// Where something is: a side, or an hour.
void takeWhere(std::string_view text, WalkTask& task, std::optional<int>* hour) {
    auto at = [&](int value) {
        if (hour != nullptr) *hour = value;
    };
    if (has(text, "slightly to your right"))
        at(1);
    else if (has(text, "slightly to your left"))
        at(11);
    else if (has(text, "behind you, on the right"))
        at(5);
    else if (has(text, "behind you, on the left"))
        at(7);
    else if (has(text, "behind you"))
        at(6);
    else if (has(text, "straight ahead"))
        at(12);
    else if (has(text, "on your left"))
        task.side = Side::Left;
    else if (has(text, "on your right"))
        task.side = Side::Right;
}

Vertical verticalIn(std::string_view text) {
    if (has(text, " up or down")) return Vertical::None;
    if (has(text, " up")) return Vertical::Up;
    return has(text, " down") ? Vertical::Down : Vertical::None;
}

Feature climbIn(std::string_view text) {
    if (has(text, "stairs")) return Feature::Stairs;
    if (has(text, "escalator")) return Feature::Escalator;
    if (has(text, "ramp")) return Feature::Ramp;
    return has(text, "lift") ? Feature::Elevator : Feature::None;
}

/// "go through the third door on your left, then turn right", "take the stairs up", "a door on your left".
bool takeTask(const std::string& clause, WalkTask& task, std::optional<int>* hour) {
    std::string_view text = clause;
    if (auto turn = turnIn(text)) {
        task.feature = Feature::Turn;
        task.turn = turn;
        return true;
    }
    bool liftDoor = begins(text, "get out of the lift") || begins(text, "go into the lift");
    bool gap = begins(text, "go through the ") || begins(text, "go straight on through the ") ||
               begins(text, "go straight on through two ") || begins(text, "follow the wall on your ") ||
               begins(text, "a door") || begins(text, "an opening");
    if (!gap && !liftDoor) {
        // Of a lift one is in already: "stay in the lift".
        bool climb = begins(text, "take the ") || begins(text, "go up the ") ||
                     begins(text, "go down the ") || begins(text, "follow the ramp") ||
                     begins(text, "stay in the lift") || begins(text, "stairs") || begins(text, "a lift") ||
                     begins(text, "an escalator") || begins(text, "a ramp");
        if (!climb) return false;
        if (std::size_t after = text.find(", after the "); after != std::string_view::npos)
            text = text.substr(0, after);
        task.feature = climbIn(text);
        task.vertical = verticalIn(text);
        takeWhere(text, task, hour);
        return task.feature != Feature::None;
    }
    std::string_view then;
    if (std::size_t comma = text.rfind(", then "); comma != std::string_view::npos) {
        then = text.substr(comma + 7);
        text = text.substr(0, comma);
    }
    // A thing on the way to the door has a side of its own.
    if (std::size_t after = text.find(", after the "); after != std::string_view::npos)
        text = text.substr(0, after);
    task.feature = has(text, "opening") ? Feature::Opening : Feature::Door;
    task.lift = liftDoor;
    task.number = ordinalIn(text);
    task.alongWall = begins(text, "follow the wall ");
    if (task.alongWall && task.number == 0) task.number = 1;
    takeWhere(text, task, hour);
    task.ahead = (has(text, " ahead") && !has(text, "ahead, slightly")) || begins(text, "go straight on");
    if (auto turn = turnIn(then)) task.behind = turn;
    if (begins(text, "go straight on")) task.turn = fromDegrees(0.0);
    std::size_t comma = text.rfind(", turning");
    if (comma != std::string_view::npos) task.turn = turnIn(text.substr(comma + 2));
    return true;
}

/// "Go straight on through two doors in a row" is two tasks, both straight ahead.
void takePair(std::string_view text, WalkTask& then) {
    if (!has(text, "straight on through two ")) return;
    then.feature = has(text, "opening") ? Feature::Opening : Feature::Door;
    then.turn = fromDegrees(0.0);
}

/// "2" of "level 2", "-1" of "level minus 1"; other names as they are.
std::string levelIn(std::string_view text) {
    if (!take(text, "level ")) return std::string(text);
    return take(text, "minus ") ? "-" + std::string(text) : std::string(text);
}

struct Fixed {
    std::string_view words;
    Order order;
    SweepStep sweep;
};

constexpr std::array<Fixed, 18> kFixed{
    {{"You have arrived", Order::Arrived, SweepStep::None},
     {"You have probably arrived", Order::Arrived, SweepStep::None},
     {"You are already there", Order::Arrived, SweepStep::None},
     {"You are probably there already", Order::Arrived, SweepStep::None},
     {"Keep moving forward", Order::GoOn, SweepStep::None},
     {"I am not sure where you are", Order::Sweep, SweepStep::Right},
     {"Now turn slowly to the left", Order::Sweep, SweepStep::Left},
     {"Hold still, and tilt the camera", Order::Sweep, SweepStep::Up},
     {"Now tilt it slowly down", Order::Sweep, SweepStep::Down},
     {"I still do not know where you are", Order::Sweep, SweepStep::AskForHelp},
     {"Thank you, that is enough", Order::Sweep, SweepStep::Done},
     {"I know no way to", Order::Halt, SweepStep::None},
     {"I do not know this destination", Order::Halt, SweepStep::None},
     {"No destination is chosen", Order::Halt, SweepStep::None},
     {"I know no way from here", Order::Halt, SweepStep::None},
     {"Stop for a moment", Order::Halt, SweepStep::None},
     {"The camera gives no picture", Order::Halt, SweepStep::None},
     {"I cannot see", Order::Halt, SweepStep::None}}};

class Listener {
public:
    WalkInstruction hear(const std::string& words) {
        std::vector<std::string> sentences = sentencesOf(words);
        for (std::size_t i = 0; i < sentences.size(); ++i) {
            bool more = i + 1 < sentences.size();
            hearSentence(sentences[i], more ? sentences[i + 1] : std::string());
            // A look around is a whole of its own.
            if (m_heard.order == Order::Sweep || m_heard.order == Order::Arrived) break;
        }
        return m_heard;
    }

private:
    void hearSentence(const std::string& sentence, const std::string& following) {
        std::string_view text = sentence;
        if (text == "Stop") {
            m_heard.stop = true;
            return;
        }
        for (const Fixed& fixed : kFixed) {
            if (!begins(text, fixed.words)) continue;
            m_heard.order = fixed.order;
            m_heard.sweep = fixed.sweep;
            // The look around goes on with "Stop, and turn".
            if (fixed.sweep == SweepStep::Right || begins(text, "Stop")) m_heard.stop = true;
            return;
        }
        if (hearDeviation(text) || hearRoute(text) || hearPlace(text)) return;
        if (take(text, "Then, straight away, ")) {
            takeTask(std::string(text), m_heard.then, nullptr);
            return;
        }
        if (hearAnnounced(text)) return;
        hearAct(sentence, following);
    }

    bool hearDeviation(std::string_view text) {
        bool left = begins(text, "You have left the route") ||
                    begins(text, "You have probably left the route") ||
                    begins(text, "You are walking the wrong way") ||
                    begins(text, "You are probably walking the wrong way") ||
                    begins(text, "You have gone too far") || begins(text, "You have probably gone too far");
        if (!left) return false;
        m_heard.astray = true;
        m_heard.order = Order::Halt;
        return true;
    }

    bool hearRoute(std::string_view text) {
        if (!begins(text, "Destination: ") && !begins(text, "I have found the way")) return false;
        m_heard.order = Order::Go;
        return true;
    }

    /// What comes along with an order: names, levels, and what is near.
    bool hearPlace(std::string_view text) {
        if (take(text, "Inside, choose: ")) {
            m_heard.task.level = levelIn(text);
            return true;
        }
        if (take(text, "Next: ")) {
            std::size_t comma = text.rfind(", your destination");
            m_heard.task.last = comma != std::string_view::npos || text == "your destination";
            if (comma != std::string_view::npos) text = text.substr(0, comma);
            // What has no name is told as what it is.
            bool named = text != "your destination" && !begins(text, "a ") && text != "outside the building";
            if (named) m_heard.task.into = std::string(text);
            return true;
        }
        if (begins(text, "At the top: ") || begins(text, "At the bottom: ") ||
            begins(text, "When you get out: "))
            return true;
        for (std::string_view thing : {"The door is ", "The opening is ", "The stairs are ", "The lift is ",
                                       "The escalator is ", "The ramp is "}) {
            if (!begins(text, thing)) continue;
            WalkTask where;
            takeWhere(text, where, &m_heard.hour);
            if (where.side != Side::None) m_heard.hour = where.side == Side::Left ? 9 : 3;
            return true;
        }
        if (begins(text, "Your destination is ")) {
            m_heard.order = Order::Go;
            m_heard.now = true;
            return true;
        }
        return begins(text, "You are probably near") || begins(text, "Careful: ") ||
               begins(text, "You are probably where you have to turn") || begins(text, "You are here") ||
               begins(text, "About ");
    }

    /// "Soon, probably, go through the door", "In about 6 metres: stairs up", "First: a bend. Follow it, …"
    bool hearAnnounced(std::string_view text) {
        std::optional<double> metres;
        if (take(text, "In about ")) {
            std::size_t used = 0;
            double count = 0.0;
            for (; used < text.size() && text[used] >= '0' && text[used] <= '9'; ++used)
                count = 10.0 * count + (text[used] - '0');
            text.remove_prefix(used);
            std::size_t end = text.find_first_of(",:");
            if (end == std::string_view::npos) return false;
            std::string_view unit = text.substr(0, end);
            metres = count * (has(unit, "f") ? 0.3048 : has(unit, "step") ? 0.7 : 1.0);
            text.remove_prefix(end);
        } else if (!take(text, "Soon, probably") && !take(text, "Soon") && !take(text, "First, probably") &&
                   !take(text, "First") && !take(text, "From here, probably") && !take(text, "From here") &&
                   !take(text, "Then")) {
            return hearBend(text);
        }
        if (!take(text, ", ") && !take(text, ": ")) return false;
        m_heard.order = Order::Go;
        m_heard.distanceM = metres;
        if (text == "a bend" || begins(text, "your destination")) return true;
        std::string_view first = text, second;
        if (std::size_t wall = text.find(", then follow the wall "); wall != std::string_view::npos) {
            first = text.substr(0, wall);
            second = text.substr(wall + 7);
        } else if (std::size_t comma = text.rfind(", then "); comma != std::string_view::npos) {
            second = text.substr(comma + 7);
            // "… then turn left" belongs to the door when nothing else is told to follow.
            if (!turnIn(second) || !(begins(text, "go ") || begins(text, "get ") || begins(text, "follow ")))
                first = text.substr(0, comma);
        }
        takeTask(std::string(first), m_heard.task, &m_heard.hour);
        if (first.size() < text.size()) takeTask(std::string(second), m_heard.then, nullptr);
        takePair(first, m_heard.then);
        return true;
    }

    bool hearBend(std::string_view text) {
        if (!take(text, "Follow it, ")) return false;
        m_heard.order = Order::Go;
        m_heard.task.feature = Feature::Turn;
        m_heard.task.turn = turnIn(text);
        return true;
    }

    /// An order for this very moment; or a turn to be made before what follows.
    void hearAct(const std::string& sentence, const std::string& following) {
        std::string clause = sentence;
        std::string_view text = clause;
        if (take(text, "Probably ") && text.size() > 6 && text.substr(text.size() - 6) == " first") {
            m_heard.turnFirst = turnIn(text.substr(0, text.size() - 6));
            return;
        }
        clause[0] = inLowerCase(clause.substr(0, 1))[0];
        bool goesOn = begins(following, "Soon") || begins(following, "In about ") ||
                      begins(following, "First") ||
                      (begins(following, "Then, ") && !begins(following, "Then, straight away"));
        if (auto turn = turnIn(clause); turn && goesOn) {
            m_heard.turnFirst = turn;
            return;
        }
        bool verb = false;
        for (std::string_view word : {"go ", "get ", "take ", "turn", "stay ", "follow "})
            verb = verb || begins(clause, word);
        WalkTask task;
        std::optional<int> hour;
        if (!verb || !takeTask(clause, task, &hour)) return;
        task.into = m_heard.task.into;
        task.last = m_heard.task.last;
        m_heard.task = task;
        takePair(clause, m_heard.then);
        if (hour) m_heard.hour = hour;
        m_heard.order = Order::Go;
        m_heard.now = true;
    }

    WalkInstruction m_heard;
};

} // namespace

WalkInstruction instructionFrom(const std::string& words) {
    return Listener().hear(words);
}

} // namespace farol::simulation
