import * as v from 'valibot';

import type { DialectManual, ManualMessage } from '../manual';
import { filesData, pageData, settingsData, VERSION } from './messages';

const noData = v.object({});
const withData = (data: v.GenericSchema) => v.object({ data });

const told: readonly (readonly [name: keyof typeof pageData, about: string])[] = [
  ['pythonReady', 'The page is there and takes messages. Those that came before are done now, in their order.'],
  [
    'code',
    'A program starts: somebody pressed Run, or `run_code` was sent. This is what runs, also after changes on the page.',
  ],
  [
    'output',
    'What the program prints, as it prints it. What is typed into the REPL after its end does not come, and its traceback comes as `error`.',
  ],
  [
    'error',
    'The exception that ended the program, as Python shows it; `KeyboardInterrupt` by the Stop button is none. Also, in one English sentence, why files cannot be opened or a run cannot start.',
  ],
  ['full_output', 'The program is over, by itself or by Stop: everything that it printed, once more.'],
  ['program_finished', 'After that: nothing more comes of this run.'],
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
        'Replaces the program, stopped; the course stays. What the pupil had is kept under “Earlier work” where the page keeps work.',
    },
    {
      name: 'settings',
      direction: 'in',
      schema: withData(settingsData),
      about: 'Sets what is shown, and how. It holds for this visit; fields and values that are unknown change nothing.',
    },
    {
      name: 'run_code',
      direction: 'in',
      schema: noData,
      about: 'Starts the program anew. It may follow `files` at once: nobody has to wait in between.',
    },
    ...out,
  ],
};
