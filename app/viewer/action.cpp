#include "app/viewer/action.h"

#include <algorithm>

namespace prairie {
namespace {

template <typename Predicate>
void perform_first(std::span<const Action> actions, Session& session, Predicate is_meant) {
  session.notice.clear();
  const auto found = std::find_if(actions.begin(), actions.end(), [&](const Action& action) {
    return action.perform && is_meant(action) && action.is_available(session);
  });
  if (found != actions.end()) found->perform(session);
}

}  // namespace

void press(Key key, std::span<const Action> actions, Session& session) {
  perform_first(actions, session, [key](const Action& action) {
    return std::find(action.keys.begin(), action.keys.end(), key) != action.keys.end();
  });
}

void perform(std::string_view name, std::span<const Action> actions, Session& session) {
  perform_first(actions, session, [name](const Action& action) { return action.name == name; });
}

}  // namespace prairie
