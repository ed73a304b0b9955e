// Downloads as a menu: used by the header for the model and its reports, by the plan for its own.
import {Icon} from "../drawing/icons";

export function ExportMenu({
  exports,
  isHere = true,
  at = "",
}: {
  exports: readonly (readonly [string, string])[];
  isHere?: boolean;
  at?: string;
}) {
  return (
    <details
      class={`menu ${at}`}
      onKeyDown={(event) => {
        if (event.key !== "Escape" || !event.currentTarget.open) return;
        event.currentTarget.open = false;
        event.preventDefault();
        event.stopPropagation();
      }}
      onFocusOut={(event) => {
        if (!event.currentTarget.contains(event.relatedTarget as Node | null)) event.currentTarget.open = false;
      }}
    >
      <summary class={`button ${isHere ? "" : "off"}`}>
        <Icon name="down" size={16} /> Export
      </summary>
      {isHere ? (
        <ul>
          {exports.map(([name, words]) => (
            <li>
              <a href={`/api/export/${name}`} download={name}>
                {words} <small>{name}</small>
              </a>
            </li>
          ))}
        </ul>
      ) : null}
    </details>
  );
}
