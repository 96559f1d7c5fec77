// One struct, one layout: the byte offsets that GLSL's scalar block layout gives each member of a shared struct (read back from the SPIR-V
// of a generated shader) are the ones that C++ gives it. The list of structs is made from the headers' text at build time.
#include "abi_headers.inc"
#include <cstddef>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

namespace
{
// SPIR-V's own numbers (section 3 of its specification).
const std::uint32_t kOpName = 5, kOpMemberName = 6, kOpTypeRuntimeArray = 29, kOpDecorate = 71, kOpMemberDecorate = 72;
const std::uint32_t kArrayStride = 6, kOffset = 35;

using Members = std::map<std::string, std::size_t>; // "Vertex.normal" -> bytes; "Vertex" -> stride of an array of it

Members membersOf(const std::vector<std::uint32_t>& words)
{
    std::map<std::uint32_t, std::string> names;                                        // id -> struct's name
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> memberNames;        // (id, index) -> member's name
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> offsets;            // (id, index) -> bytes
    std::map<std::uint32_t, std::size_t> strides;                                      // array's id -> bytes
    std::map<std::uint32_t, std::uint32_t> elements;                                   // array's id -> element's id
    for (std::size_t at = 5; at < words.size(); at += std::max(words[at] >> 16, 1u)) { // after the header's five words
        const std::uint32_t* w = &words[at];
        switch (w[0] & 0xffffu) {
        case kOpName:
            names[w[1]] = reinterpret_cast<const char*>(w + 2);
            break;
        case kOpMemberName:
            memberNames[{w[1], w[2]}] = reinterpret_cast<const char*>(w + 3);
            break;
        case kOpTypeRuntimeArray:
            elements[w[1]] = w[2];
            break;
        case kOpDecorate:
            if (w[2] == kArrayStride) strides[w[1]] = w[3];
            break;
        case kOpMemberDecorate:
            if (w[3] == kOffset) offsets[{w[1], w[2]}] = w[4];
            break;
        }
    }
    Members found;
    for (const auto& [member, bytes] : offsets) found[names[member.first] + "." + memberNames[member]] = bytes;
    for (const auto& [array, element] : elements) found[names[element]] = strides[array];
    return found;
}

Members shaderMembers()
{
    std::ifstream file(AFTERGLOW_ABI_SPIRV, std::ios::binary);
    std::vector<std::uint32_t> words;
    for (std::uint32_t word; file.read(reinterpret_cast<char*>(&word), sizeof word);) words.push_back(word);
    return membersOf(words);
}

TEST(Abi, every_member_of_every_shared_struct_has_one_offset)
{
    using namespace shared;
    const Members shader = shaderMembers();
    int compared = 0;
    const auto same = [&](const std::string& what, std::size_t bytes) {
        ASSERT_TRUE(shader.count(what)) << what << " is missing from the SPIR-V";
        EXPECT_EQ(shader.at(what), bytes) << what << ": GLSL, then C++";
        ++compared;
    };
#define MEMBER(type, member) same(#type "." #member, offsetof(type, member));
#define SIZE(type) same(#type, sizeof(type));
#include "abi_members.inc"
    EXPECT_GT(compared, 70); // the level's structs alone (shaders/scene.h) have more members than that
}

// The reader itself: a struct whose two members are swapped in the SPIR-V must not pass for the original.
TEST(Abi, reads_offsets_by_name_not_by_order)
{
    const auto instruction = [](std::uint32_t op, std::vector<std::uint32_t> operands) {
        operands.insert(operands.begin(), op | std::uint32_t(operands.size() + 1) << 16);
        return operands;
    };
    std::vector<std::uint32_t> words(5);
    for (const auto& part :
         {instruction(kOpName, {7, 'S'}), instruction(kOpMemberName, {7, 0, 'b'}), instruction(kOpMemberName, {7, 1, 'a'}),
          instruction(kOpMemberDecorate, {7, 0, kOffset, 0}), instruction(kOpMemberDecorate, {7, 1, kOffset, 12})})
        words.insert(words.end(), part.begin(), part.end());
    const Members members = membersOf(words);
    EXPECT_EQ(members.at("S.a"), 12u);
    EXPECT_EQ(members.at("S.b"), 0u);
}
}
