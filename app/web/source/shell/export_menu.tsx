// Menu of downloads: used by the header for the model and its reports, and by the plan view for the plan.
import {Icon} from "../drawing/icons";
import {Menu} from "./menu";

interface ExportMenuProps {
  exports: readonly (readonly [string, string])[];
  isHere?: boolean;
  at?: string;
}

export function ExportMenu({exports, isHere = true, at = ""}: ExportMenuProps) {
  const button = (
    <>
      <Icon name="down" size={16} /> Export
    </>
  );
  return (
    <Menu kind={at} buttonKind={`button ${isHere ? "" : "off"}`} isOff={!isHere} button={button}>
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
    </Menu>
  );
}
