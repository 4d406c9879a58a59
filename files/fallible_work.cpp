#include "files/fallible_work.h"

#include <algorithm>
#include <new>
#include <utility>

#include "files/byte_message.h"
#include "files/error.h"

namespace prairie {
namespace {

enum class Reply : std::uint8_t { kResult, kBadInput, kNoMemory };

MessageWriter begun(Reply kind) {
  MessageWriter message;
  message.put(static_cast<std::uint8_t>(kind));
  return message;
}

}  // namespace

Work fallible(Work work) {
  return [work = std::move(work)](std::span<const std::byte> request, const MessageSink& reply) {
    try {
      work(request, [&reply](std::span<const std::byte> bytes) {
        reply(begun(Reply::kResult).append(bytes).bytes());
      });
    } catch (const BadInput& error) {
      MessageWriter message = begun(Reply::kBadInput);
      for (const std::string* part : {&error.file, &error.field, &error.found, &error.expected})
        message.put(*part);
      reply(message.bytes());
    } catch (const std::bad_alloc&) {
      reply(begun(Reply::kNoMemory).bytes());
    }
  };
}

Work chosen_by_name(std::vector<std::pair<std::string, Work>> works) {
  return [works = std::move(works)](std::span<const std::byte> request, const MessageSink& reply) {
    MessageReader reader(request);
    const std::string name = reader.text();
    const auto chosen = std::ranges::find(works, name, &std::pair<std::string, Work>::first);
    if (chosen != works.end()) chosen->second(reader.rest(), reply);
  };
}

void run_fallible(WorkerProcess& process, std::span<const std::byte> request, const WorkLimits& limits,
                  const WorkInput& input, const MessageSink& on_reply) {
  try {
    process.run(request, limits, [&](std::span<const std::byte> bytes) {
      MessageReader reader(bytes);
      switch (static_cast<Reply>(reader.number<std::uint8_t>())) {
        case Reply::kResult:
          return on_reply(reader.rest());
        case Reply::kBadInput: {
          const std::string file = reader.text();
          const std::string field = reader.text();
          const std::string found = reader.text();
          throw BadInput(file, field, found, reader.text());
        }
        case Reply::kNoMemory:
          throw WorkFailed("needs more memory than it is worth");
      }
      throw BrokenMessage();
    });
  } catch (const WorkFailed& failure) {
    throw BadInput(input.file, input.field, std::string("a file that ") + failure.what(),
                   "one that can be read");
  } catch (const BrokenMessage&) {
    throw BadInput(input.file, input.field, "a file that confuses its decoder", "one that can be read");
  }
}

}  // namespace prairie
