/** The subjects of `npm run bench`: every budget of docs/architecture.md, in the order of its table. */
import { apiCallsSubject } from './api-calls';
import { headlessSubjects } from './headless';
import { classSubject, openClassSubject } from './page/class';
import { debugSubject } from './page/debug';
import { whySubject } from './page/why';
import { downloadSubject } from './page/download';
import { editingSubject, movingSubject, slowMovingSubject } from './page/editing';
import { fanSubject, fourRobotsSubject, framesSubject } from './page/frames';
import { eightDevicesMemorySubject, memorySubject } from './page/memory';
import type { Stage } from './page/stage';
import { runsSubject } from './page/runs';
import { startSubject } from './page/start';
import { stopSubject } from './page/stop';
import { sweepSubject } from './page/sweep';
import { goOnSubject, scrubSubject } from './page/time';
import { measured, named, skipped, type Row } from './subject';

const pageSubjects = [
  startSubject,
  downloadSubject,
  framesSubject,
  fanSubject,
  fourRobotsSubject,
  editingSubject,
  movingSubject,
  slowMovingSubject,
  memorySubject,
  eightDevicesMemorySubject,
  runsSubject,
  stopSubject,
  debugSubject,
  scrubSubject,
  goOnSubject,
  whySubject,
  classSubject,
  openClassSubject,
  sweepSubject,
];

export { apiCalls } from './api-calls';
export { hintLine, hintRows, hintSums } from './hints';

/** The lines that need no browser and have `words` in their names. Runs in the project's folder after set-up. */
export const headlessRows = (words: string): AsyncGenerator<Row> =>
  measured(named([...headlessSubjects, apiCallsSubject], words), undefined);

/** The lines about the page in Chromium that have `words` in their names. */
export const pageRows = (stage: Stage, words: string): AsyncGenerator<Row> =>
  measured(named(pageSubjects, words), stage);

/** The same lines if there is no Chromium. */
export const skippedPageRows = (reason: string, words: string): Row[] => skipped(named(pageSubjects, words), reason);
