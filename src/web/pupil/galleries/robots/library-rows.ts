import { textsOfRobot } from '#reference/texts';
import type { Entry, Names, ReferenceModule, RobotReference } from '#reference/types';

import type { Language } from '../../../kit/i18n/texts';

/** A library as a table: what it is for, and a row for each name. */
export interface LibraryTable {
  readonly module: string;
  readonly text: string;
  readonly rows: readonly LibraryRow[];
}

export interface LibraryRow {
  /**
   * As it is written in a program: `setSpeed(speed: int)`, `irLeft: IRSensor`, `Motor.rotate(speed: int)`. Several of
   * them where the same can be written in several ways, and where several names in a row do the same.
   */
  readonly codes: readonly string[];
  readonly text: string;
}

/** The libraries of a robot with their words; what the firmware does not have is left out. */
export function libraryTables(reference: RobotReference, language: Language): readonly LibraryTable[] {
  const words = textsOfRobot(reference, language);
  return reference.modules.map((module) => ({
    module: module.name,
    text: words[module.name] ?? '',
    rows: rowsOf(module, words),
  }));
}

function rowsOf(module: ReferenceModule, words: Readonly<Record<string, string>>): readonly LibraryRow[] {
  const rows: LibraryRow[] = [];
  const add = (names: Names, key: string, prefix: string): void => {
    for (const [name, entry] of Object.entries(names)) {
      if (entry.absent) continue;
      const text = words[entry.text ?? `${key}.${name}`] ?? '';
      const codes = codesOf(prefix + name, entry);
      const last = rows.at(-1);
      if (last !== undefined && text !== '' && last.text === text)
        rows[rows.length - 1] = { text, codes: [...last.codes, ...codes] };
      else rows.push({ codes, text });
      add(entry.members, `${key}.${name}`, `${prefix}${name}.`);
    }
  };
  add(module.names, module.name, '');
  return rows;
}

/** The forms of a call; a function without a result does not mention it, and a parameter of any type has no type. */
function codesOf(name: string, { calls, type }: Entry): readonly string[] {
  if (calls.length > 0) return calls.map((call) => name + call.replace(/ -> None$/, '').replace('(*arguments)', '(…)'));
  return [type === null ? name : `${name}: ${type}`];
}
