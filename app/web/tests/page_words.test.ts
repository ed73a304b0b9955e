// Tests of the translation of command-line messages to the wording of the page.
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
    expect(pageAdvice("leave the line out; write --travel line")).toBe("leave the line out");
    expect(pageAdvice("choose another (GET /api/files lists them)")).toBe("choose another");
    expect(pageWords("two units, or equally --assume units=mm")).toBe("two units");
    expect(pageWords("they are copies; --assume as-is counts every row")).toBe("they are copies");
    expect(pageWords("turns in the form zyz, as `readings --orientation zyz` takes them")).toBe(
      "turns in the form zyz",
    );
    expect(pageWords("state it joint by joint, as --assume joint-scale=theta1:FACTOR")).toBe("state it joint by joint");
    expect(pageWords("no path was found (another --seed may)")).toBe("no path was found");
  });
  it("have the bare names of options and of keys of a request", () => {
    expect(pageWords("goal-point compensation cannot go with --travel line")).toBe(
      "goal-point compensation cannot go with travel line",
    );
    expect(pageWords("request (hole)")).toBe("hole");
    expect(pageWords("found -1, expected 0--9")).toBe("found -1, expected 0--9");
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
  it("keep a sentence that has no expected value", () => {
    expect(
      pageProblem({
        where: "cell",
        found: "another cell cannot be opened while a job is running",
        expected: "",
        message: "m",
      }),
    ).toMatchObject({
      found: "another cell cannot be opened while a job is running",
      expected: "",
    });
  });
});
