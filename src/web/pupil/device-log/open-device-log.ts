import { readDeviceLog } from '#device-log/read-device-log';
import type { Document } from '#intake/document';
import { openLog } from '#intake/file';
import { inMB, limits } from '#intake/formats';

import { treeFile } from '../../kit/files/added-files';
import { t } from '../../kit/i18n';
import type { OpenedLog } from '../../session/run/data-log-model';
import words from './words';
import { problemText } from './log-texts';
import type { TakesLogs } from './takes-logs';

/** A file of readings that was read. */
interface GivenLog {
  readonly file: File;
  readonly document: Document;
}

/**
 * Shows the readings of a file beside those of the simulation, of several the last. What cannot be read gives a message
 * and changes nothing.
 */
export function openDeviceLogs(app: TakesLogs, files: readonly GivenLog[]): void {
  const refusals: string[] = [];
  const opened: OpenedLog[] = [];
  for (const file of files) {
    const read = logIn(file);
    if (typeof read === 'string') refusals.push(read);
    else opened.push(read);
  }
  const last = opened.at(-1);
  if (last !== undefined) {
    app.dataLog.device.value = last;
    app.dataLog.isCompared.value = true;
    app.settings.change({ panel: 'log' });
  }
  const several = opened.length > 1 && last !== undefined ? t(words.severalFiles, { file: last.file }) : '';
  const text = [...refusals, several].join(' ').trim();
  const kind = refusals.length > 0 ? 'error' : 'info';
  if (text !== '') app.notices.show({ kind, key: 'notice.text', values: { text } });
}

/** Shows the readings of files that were chosen as such, whatever they are called. */
export async function openChosenLogs(app: TakesLogs, files: readonly File[]): Promise<void> {
  const chosen = files.map(async (file) => ({ file, document: await openLog(treeFile({ path: file.name, file })) }));
  openDeviceLogs(app, await Promise.all(chosen));
}

/** @returns the log, or why there is none, in words */
function logIn({ file: { name: file, size: bytes }, document }: GivenLog): OpenedLog | string {
  if (document.kind !== 'log') {
    const isLarge = document.kind === 'unreadable' && document.problem.code === 'large';
    const values = { file, size: inMB(bytes), max: inMB(limits.log) };
    return t(words.problems[isLarge ? 'tooLarge' : 'unreadable'], values);
  }
  const read = readDeviceLog(document.bytes);
  return read.kind === 'log' ? { file, log: read.log } : problemText(file, read.problem);
}
