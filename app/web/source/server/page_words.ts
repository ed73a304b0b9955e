// Translation of the program's messages from its command line to the page, on which options are fields and buttons.
import type {Problem} from "./documents";

/** Advice that names an option, and its equivalent on the page; advice without an equivalent is omitted. */
const ADVICE: readonly (readonly [RegExp, string])[] = [
  [/--(column|units)\b/, "Choose above what each column is, and its unit."],
  [/--(dates|orientation|points|kind)\b/, "Choose it below the tables."],
  [/--sigma\b/, "Enter one standard deviation of a coordinate below the tables."],
  [/--touches\b/, "Touch holes under Calibrate."],
  [/--tubes\b/, "Select holes on the sheet."],
  [/`tubeplan compare/, "Open readings: under Error stands what the error depends on."],
  [/--[a-z]|`tubeplan /, ""],
];

/** Returns the text without options that it offers as an alternative. */
export function pageWords(text: string): string {
  return text
    .replace(/ \(--[^)]*\)/g, "")
    .replace(/,? or (equally )?--[a-z-]+([ =][^\s,;]+)?/g, "")
    .replace(/^--(?=[a-z])/, "");
}

export function pageAdvice(text: string): string {
  const plain = pageWords(text);
  return ADVICE.find(([option]) => option.test(plain))?.[1] ?? plain;
}

export function pageProblem({where = "", found = "", expected = "", advice = "", message}: Problem): Required<Problem> {
  const [at, had, wanted, said] = [where, found, expected, message].map(pageWords);
  return {where: at, found: had, expected: wanted, message: said, advice: pageAdvice(advice)};
}
