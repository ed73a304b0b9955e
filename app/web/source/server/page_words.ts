// Translation of the program's messages, worded for the command line, to the page, where options are fields and
// buttons.
import type {Problem} from "./documents";

/** Options named in advice, and the equivalent advice on the page. */
const ADVICE: readonly (readonly [RegExp, string])[] = [
  [/--(column|units)\b/, "Choose above what each column is, and its unit."],
  [/--(dates|orientation|points|kind)\b/, "Choose it below the tables."],
  [/--sigma\b/, "Enter one standard deviation of a coordinate below the tables."],
  [/--touches\b/, "Touch holes under Calibrate."],
  [/--tubes\b/, "Select holes on the sheet."],
  [/`tubeplan compare/, "Open readings: the view Error shows what the error depends on."],
];

const NAMES_A_COMMAND = /--[a-z]|`tubeplan /;

/** Returns the text without alternatives that exist only for commands or requests, such as options and addresses. */
function withoutAlternatives(text: string): string {
  return text
    .replace(/ \([^()]*--[a-z][^()]*\)/g, "")
    .replace(/ \((GET|POST|DELETE) \/[^()]*\)/g, "")
    .replace(/,? or (equally )?--[a-z-]+([ =][^\s,;]+)?/g, "")
    .replace(/[,;] (as )?(`[^`]*--[^`]*`|--[a-z]).*?(?=[,;]|: |$)/g, "");
}

/** Returns the text without alternatives that only commands have; options and request keys become bare names. */
export function pageWords(text: string): string {
  return withoutAlternatives(text)
    .replace(/^request \(([\w-]+)\)/, "$1")
    .replace(/(^|[^\w-])--(?=[a-z])/g, "$1");
}

/** Returns advice worded for the page. Clauses that name a command and have no equivalent on the page are omitted. */
export function pageAdvice(text: string): string {
  const plain = withoutAlternatives(text);
  const equivalent = ADVICE.find(([option]) => option.test(plain))?.[1];
  if (equivalent !== undefined) return equivalent;
  return plain
    .split("; ")
    .filter((clause) => !NAMES_A_COMMAND.test(clause))
    .join("; ");
}

/** Returns the problem with its texts adapted to the page; `expected` is empty unless the problem is a wrong value. */
export function pageProblem({
  where = "",
  found = "",
  expected = "",
  advice = "",
  message,
}: Problem): Required<Omit<Problem, "choice">> {
  const [at, had, wanted, said] = [where, found, expected, message].map(pageWords);
  return {where: at, found: had, expected: wanted, message: said, advice: pageAdvice(advice)};
}
