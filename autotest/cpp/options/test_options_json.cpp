// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
#include <gtest/gtest.h>

#include <set>

#include "json_reader.h"
#include "options/options_json.h"
#include "test_table.h"

namespace qmesh {
namespace {

std::string textOf(const Json& object, const std::string& key) {
  return object.has(key) ? object[key].text : std::string();
}

TEST(OptionsJson, HasEveryRow) {
  const std::string text = optionsJson(testTable(), "1.2\"3");
  const Json json = JsonReader(text).read();
  EXPECT_EQ(json["program"].text, "gdal2qmesh");
  EXPECT_EQ(json["version"].text, "1.2\"3");
  const std::vector<OptionRow>& rows = testTable().rows();
  const std::vector<Json>& options = json["options"].items;
  ASSERT_EQ(options.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(options[i]["name"].text, rows[i].name);
    EXPECT_EQ(options[i]["help"].text, rows[i].help);
    EXPECT_EQ(options[i]["values"].number, rows[i].values);
    EXPECT_EQ(textOf(options[i], "default"), rows[i].defaultText());
    EXPECT_EQ(textOf(options[i], "unit"), rows[i].unit);
    EXPECT_EQ(options[i].has("minimum"), rows[i].minimum.has_value());
    EXPECT_EQ(options[i].has("advanced"), rows[i].advanced);
    if (rows[i].choices.empty())
      continue;
    ASSERT_EQ(options[i]["choices"].items.size(), rows[i].choices.size());
    EXPECT_EQ(options[i]["choices"].items.back()["name"].text, rows[i].choices.back().name);
  }
}

TEST(OptionsJson, NamesTheMethodsOfARow) {
  const std::string text = optionsJson(testTable(), "1");
  const Json json = JsonReader(text).read();
  int ofMethods = 0;
  for (std::size_t i = 0; i < testTable().rows().size(); ++i) {
    const std::vector<std::string>& methods = testTable().rows()[i].methods;
    const Json& option = json["options"].items[i];
    ASSERT_EQ(option.has("methods"), !methods.empty());
    ofMethods += methods.empty() ? 0 : 1;
    for (std::size_t k = 0; k < methods.size(); ++k)
      EXPECT_EQ(option["methods"].items[k].text, methods[k]);
  }
  EXPECT_GT(ofMethods, 15);
}

TEST(OptionsJson, GroupsAreThoseOfTheRows) {
  const std::string text = optionsJson(testTable(), "1");
  const Json json = JsonReader(text).read();
  std::set<std::string> groups;
  for (const Json& group : json["groups"].items)
    groups.insert(group["name"].text);
  for (const Json& option : json["options"].items)
    EXPECT_TRUE(groups.count(option["group"].text)) << option["name"].text;
}

} // namespace
} // namespace qmesh
