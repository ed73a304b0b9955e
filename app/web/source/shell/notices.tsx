// Notices of refusals and failures in the program's words, and of successful actions, shown until they are dismissed.
import {Icon} from "../drawing/icons";
import {dismiss, notices} from "../server/workbench";
import {ProblemWords} from "./states";

export function Notices() {
  return (
    <div class="notices" role="alert" aria-live="assertive">
      {notices.value.map((notice) => (
        <section class={`notice ${notice.isNote ? "note-of-success" : ""}`} key={notice.id}>
          <header>
            <h2>{notice.title}</h2>
            <button class="tool" title="Dismiss (Esc)" onClick={() => dismiss(notice.id)}>
              <Icon name="close" size={16} />
            </button>
          </header>
          <ProblemWords problem={notice.problem} />
        </section>
      ))}
    </div>
  );
}
