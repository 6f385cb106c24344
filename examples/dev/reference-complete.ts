import { complete } from '#reference/complete';

import type { Print } from './example';

/** reference: what could follow in a half-written program. */
export function main(print: Print): void {
  const program = 'from microbit import *\ndisplay.sc';
  const context = { board: 'microbit-v2', features: [], modules: [], files: {} } as const;
  const offers = complete(program, program.length, context);
  print(
    (offers?.items ?? [])
      .map(({ item }) => item.label)
      .filter((label) => label.startsWith('sc'))
      .join(', '),
  );
}
