import * as v from 'valibot';

import type { DialectManual, ManualMessage } from '../manual';
import { filesData, pageData, settingsData, VERSION } from './messages';

const noData = v.object({});
const withData = (data: v.GenericSchema) => v.object({ data });

const told: readonly (readonly [name: keyof typeof pageData, about: string])[] = [
  ['pythonReady', 'The page is ready for messages. Messages that came earlier are now carried out in order.'],
  [
    'code',
    'A program starts, by the Run button or by `run_code`. These are the files that run, with any changes made on the page.',
  ],
  [
    'output',
    'Output of the program, as it is printed. Input typed into the REPL after the end of the program is not sent. A traceback comes as `error`.',
  ],
  [
    'error',
    'The exception that ended the program, as Python shows it (not `KeyboardInterrupt` by the Stop button). Or one English sentence that says why files cannot be opened or a run cannot start.',
  ],
  ['full_output', 'The program is over, by itself or by Stop. This is its whole output once more.'],
  ['program_finished', 'Comes after `full_output`: no more messages of this run follow.'],
];

const out: readonly ManualMessage[] = told.map(([name, about]) => ({
  name,
  direction: 'out',
  schema: withData(pageData[name]),
  about,
}));

/** This dialect for the manual. */
export const manual: DialectManual = {
  title: 'The dialect of WebTigerPython',
  version: VERSION,
  messages: [
    {
      name: 'files',
      direction: 'in',
      schema: withData(filesData),
      about:
        'Replaces the program, stopped; the course stays. Previous work of the pupil is kept under “My work” if the page keeps work.',
    },
    {
      name: 'settings',
      direction: 'in',
      schema: withData(settingsData),
      about: 'Sets what is shown, and how. It holds for this visit. Unknown fields and values change nothing.',
    },
    {
      name: 'run_code',
      direction: 'in',
      schema: noData,
      about: 'Starts the program anew. It may follow `files` at once, without waiting.',
    },
    ...out,
  ],
};
