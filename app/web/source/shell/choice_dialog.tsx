// Dialog for a request that the program refuses until one choice is made, such as the tip of a robot with several ends.
import {signal} from "@preact/signals";
import {Select, submitting} from "../drawing/fields";
import type {Problem} from "../server/documents";
import {asProblem} from "../server/requests";
import {attempt} from "../server/workbench";
import {Dialog} from "./dialog";
import {closeDialog, dialog} from "./page_state";
import {ProblemWords} from "./states";

/** Choices made so far, under their names for the server. */
export type Choices = Record<string, string>;

interface Question {
  problem: Problem;
  chosen: string;
  /** Repeats the request with a value of the choice. */
  answer: (value: string) => Promise<boolean>;
}

const question = signal<Question | null>(null);

/**
 * Runs an action as attempt() does. If a choice would avoid the refusal of its request, the dialog offers the choice and
 * runs the action again with it.
 */
export function attemptWithChoices(
  title: string,
  act: (choices: Choices) => Promise<void>,
  about: string,
  choices: Choices = {},
): Promise<boolean> {
  const actOrOffer = async () => {
    try {
      await act(choices);
    } catch (error) {
      const problem = asProblem(error),
        {choice} = problem;
      if (!choice) throw error;
      const answer = (value: string) => attemptWithChoices(title, act, about, {...choices, [choice.name]: value});
      question.value = {problem, chosen: choice.values[0].value, answer};
      dialog.value = "choice";
    }
  };
  return attempt(title, actOrOffer, about);
}

export function ChoiceDialog() {
  return (
    <Dialog name="choice" title="A choice is needed">
      {question.value ? <ChoiceForm shown={question.value} /> : null}
    </Dialog>
  );
}

function ChoiceForm({shown}: {shown: Question}) {
  const {label, values} = shown.problem.choice!;
  const submit = () => {
    closeDialog("choice");
    return shown.answer(shown.chosen);
  };
  return (
    <form class="choice-form" onSubmit={submitting(submit)}>
      <ProblemWords problem={shown.problem} />
      <label class="field">
        {label}
        <Select choices={values} value={shown.chosen} onChoose={(chosen) => (question.value = {...shown, chosen})} />
      </label>
      <div class="row">
        <button class="button first" type="submit">
          Go on
        </button>
      </div>
    </form>
  );
}
