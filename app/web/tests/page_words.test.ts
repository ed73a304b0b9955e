// Tests of the program's command-line messages as the page words them.
import {describe, expect, it} from "vitest";
import {pageAdvice, pageProblem, pageWords} from "../source/server/page_words";

describe("the page's words", () => {
  const OF_OPTIONS = [
    "say which: --column x=points.txt:X",
    "say which: --dates day-first or --dates month-first",
    "add a column sigma_in or --sigma",
    "touch it again, or leave it out (--assume without=T2)",
    "`tubeplan compare CELL TOUCHES` shows what the error depends on",
    "repeat them, or omit --resume to start again",
  ];
  it("name no option of a command", () => {
    for (const text of OF_OPTIONS) expect(pageAdvice(text)).not.toMatch(/--[a-z]|`tubeplan/);
  });
  it("keep what can be done without one", () => {
    expect(pageAdvice(OF_OPTIONS[2])).toBe("add a column sigma_in");
    expect(pageAdvice(OF_OPTIONS[3])).toBe("touch it again, or leave it out");
    expect(pageAdvice("touch a fourth hole")).toBe("touch a fourth hole");
    expect(pageWords("two units, or equally --assume units=mm")).toBe("two units");
  });
  it("point to the field that does the same", () => {
    expect(pageAdvice(OF_OPTIONS[0])).toMatch(/column/);
    expect(pageAdvice(OF_OPTIONS[1])).toMatch(/below the tables/);
    expect(pageProblem({where: "--readings", found: "nothing", message: "m"})).toMatchObject({
      where: "readings",
      found: "nothing",
      advice: "",
    });
  });
});
