/** What `npm run bench` measures: every budget of docs/architecture.md, in the order of its table. */
import { apiCallsSubject } from './api-calls';
import { headlessSubjects } from './headless';
import { downloadSubject } from './page/download';
import { editingSubject } from './page/editing';
import { fourRobotsSubject, framesSubject } from './page/frames';
import { eightDevicesMemorySubject, memorySubject } from './page/memory';
import type { Stage } from './page/stage';
import { runsSubject } from './page/runs';
import { startSubject } from './page/start';
import { stopSubject } from './page/stop';
import { measured, skipped, type Row } from './subject';

const pageSubjects = [
  startSubject,
  downloadSubject,
  framesSubject,
  fourRobotsSubject,
  editingSubject,
  memorySubject,
  eightDevicesMemorySubject,
  runsSubject,
  stopSubject,
];

export { apiCalls } from './api-calls';

/** The lines that need no browser. Runs in the project's folder after set-up. */
export const headlessRows = (): AsyncGenerator<Row> => measured([...headlessSubjects, apiCallsSubject], undefined);

/** The lines about the page in Chromium. */
export const pageRows = (stage: Stage): AsyncGenerator<Row> => measured(pageSubjects, stage);

/** The same lines if there is no Chromium. */
export const skippedPageRows = (reason: string): Row[] => skipped(pageSubjects, reason);
