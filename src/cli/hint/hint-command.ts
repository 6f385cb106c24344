import { unreadText } from '#check/report/say';
import { hintFor } from '#hint/hint';
import { hintJson } from '#hint/hint-json';
import { hintText, passedText } from '#hint/say';
import { contentOf } from '#intake/sources';
import { findHandIns } from '../check/sources';
import { readTask } from '../check/read-task';
import { readFirmware } from '../firmware';
import { refuse } from '../results-out';
import { printable, type Terminal } from '../terminal';
import type { HintOptions } from './hint-arguments';

/**
 * Carries out `parcours hint`.
 *
 * @returns the exit code: 0 the program passes, 3 it does not, 2 bad usage
 */
export async function giveHint(options: HintOptions, terminal: Terminal): Promise<0 | 2 | 3> {
  const { level, budget, json, lang, program } = options;
  const read = await readTask(options.task);
  if ('problem' in read) return refuse(read.problem, terminal);
  const found = await findHandIns([program]);
  if ('problem' in found) return refuse(found.problem, terminal);
  const [source, another] = found.sources;
  if (source === undefined) return refuse(`${program}: there is no program.`, terminal);
  if (another !== undefined) return refuse(`${program}: there are several hand-ins. A hint is for one.`, terminal);
  const content = await contentOf(source);
  if ('problem' in content) return refuse(`${program}: ${unreadText(content.problem, lang)}`, terminal);
  const firmware = await WebAssembly.compile(readFirmware());
  const hint = await hintFor(read.task, content.handIn, { firmware, budget });
  if (json) terminal.line(hintJson(hint, level, lang));
  else terminal.line(printable(hint === null ? passedText(lang) : hintText(hint, level, lang)));
  return hint === null ? 0 : 3;
}
