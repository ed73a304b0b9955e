// A work list from a file: its tubes become the selection, and what is left out of it is said.
import {post} from "../server/requests";
import {report} from "../server/workbench";
import {selection} from "../shell/page_state";

interface WorkListDocument {
  name: string;
  tubes: number[];
  notes: string[];
}

async function openList(file: File): Promise<void> {
  try {
    const list = await post<WorkListDocument>("/api/tubes", {name: file.name, text: await file.text()});
    selection.value = new Set(list.tubes);
    if (list.notes.length > 0) report(list.name, {message: list.notes.join("; ")});
  } catch (error) {
    report(`${file.name} cannot be read`, error);
  }
}

export function WorkListButton() {
  return (
    <label class="button" title="a CSV of tubes, as plan --tubes LIST.csv reads it: they become the selection">
      Work list …
      <input
        class="hidden"
        type="file"
        accept=".csv,.txt,.tsv,text/csv,text/plain"
        onChange={(event) => {
          const input = event.currentTarget,
            file = input.files?.[0];
          if (file) void openList(file);
          input.value = ""; // the same file may be opened again
        }}
      />
    </label>
  );
}
