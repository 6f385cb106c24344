import type { Texts } from '#core/languages';
import type { SourceFile } from '#project/project';
import type { Hardware } from '#simulation/hardware';

/** The option of a robot that says what comes first in the numbers of its lidar's fields, and the choice beside the maker's. */
const ORDER = { option: 'lidarOrder', choice: 'transposed' } as const;

/** Commands of a lidar whose fields are named by column and row: in `mbrobot_plusV3` of WebTigerPython. */
const FIELDS = /^[^#\n]*\bgetDistance(?:At|Grid|Row|Column)\s*\(/m;

/** True if a program asks a lidar for single fields, columns or rows. */
export const asksForFields = (files: readonly SourceFile[]): boolean => files.some(({ text }) => FIELDS.test(text));

/**
 * The option and the choice with which a robot's lidar counts its fields as some programs of WebTigerPython do; `null`: the
 * robot has none, or has it already.
 */
export function otherOrder({ robot, options }: Hardware): { readonly option: Texts; readonly choice: Texts } | null {
  const option = robot?.options.find(({ id }) => id === ORDER.option);
  const choice = option?.choices.find(({ id }) => id === ORDER.choice);
  if (option === undefined || choice === undefined || options[ORDER.option] === ORDER.choice) return null;
  return { option: option.title, choice: choice.title };
}
