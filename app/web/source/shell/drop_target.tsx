// Target for files dropped anywhere on the page: readings, a log of joints and a file of points together, a work list,
// or a robot description.
import {useEffect} from "preact/hooks";
import {useSignal} from "@preact/signals";
import {loadFiles} from "./load";

function hasFiles(event: DragEvent): boolean {
  return event.dataTransfer !== null && [...event.dataTransfer.types].includes("Files");
}

export function DropTarget() {
  const isOver = useSignal(false);
  useEffect(() => {
    const over = (event: DragEvent) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      isOver.value = true;
    };
    const leave = (event: DragEvent) => {
      if (event.relatedTarget === null) isOver.value = false;
    };
    const drop = (event: DragEvent) => {
      if (!hasFiles(event)) return;
      event.preventDefault();
      isOver.value = false;
      const files = [...(event.dataTransfer?.files ?? [])];
      if (files.length > 0) void loadFiles(files);
    };
    const listening = new AbortController(),
      {signal} = listening;
    window.addEventListener("dragover", over, {signal});
    window.addEventListener("dragleave", leave, {signal});
    window.addEventListener("drop", drop, {signal});
    return () => listening.abort();
  }, []);
  return isOver.value ? (
    <div class="drop">
      <p>Drop readings, a work list or a URDF here</p>
    </div>
  ) : null;
}
