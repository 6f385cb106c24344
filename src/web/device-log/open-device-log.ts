import { readDeviceLog } from '#device-log/read-device-log';

import { say } from '../page/i18n/say';
import type { OpenedLog } from '../run/data-log-model';
import { deviceLogWords as words } from './device-log-words';
import { problemText } from './log-texts';
import type { TakesLogs } from './takes-logs';

/** Largest file that is read: a micro:bit's page has 0.13 MB, and its table from a spreadsheet twice as much at most. */
const MAX_MB = 1; // chosen: a weak tablet reads it in two or three seconds

/** Shows the readings of a file beside those of the simulation, of several the last. What cannot be read gives a message and changes nothing. */
export async function openDeviceLogs(app: TakesLogs, files: readonly File[]): Promise<void> {
  const refusals: string[] = [];
  const opened: OpenedLog[] = [];
  for (const file of files) {
    const read = await readFile(file);
    if (typeof read === 'string') refusals.push(read);
    else opened.push(read);
  }
  const last = opened.at(-1);
  if (last !== undefined) {
    app.dataLog.device.value = last;
    app.dataLog.isCompared.value = true;
    app.settings.change({ panel: 'log' });
  }
  const several = opened.length > 1 && last !== undefined ? say(words.severalFiles, { file: last.file }) : '';
  const text = [...refusals, several].join(' ').trim();
  const kind = refusals.length > 0 ? 'error' : 'info';
  if (text !== '') app.notices.show({ kind, key: 'notice.text', values: { text } });
}

/** @returns the log, or why there is none, in words */
async function readFile(given: File): Promise<OpenedLog | string> {
  const file = given.name;
  const sizeMB = given.size / 1024 / 1024;
  if (sizeMB > MAX_MB) return say(words.problems.tooLarge, { file, size: Math.ceil(sizeMB), max: MAX_MB });
  const bytes = await given.arrayBuffer().catch(() => null);
  if (bytes === null) return say(words.problems.unreadable, { file });
  const read = readDeviceLog(new Uint8Array(bytes));
  return read.kind === 'log' ? { file, log: read.log } : problemText(file, read.problem);
}
