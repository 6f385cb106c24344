import { unreadText } from '#check/report/say';
import { hintJson } from '#hint/hint-json';
import { HintLane } from '#hint/hint-lane';
import { hintText, passedText } from '#hint/say';
import { contentOf } from '#intake/sources';
import { findHandIns } from '../check/sources';
import { readTask } from '../check/read-task';
import { readFirmware } from '../firmware';
import { refuse } from '../results-out';
import { printable, type Terminal } from '../terminal';
import { every } from '../threads/threads';
import type { HintOptions } from './hint-arguments';
import { hintThread } from './hint-thread';

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
  const { task } = read;
  const lane = new HintLane(task, hintThread(task, firmware), every);
  const hint = await lane.hint(content.handIn, budget);
  lane.stop();
  if (json) terminal.line(hintJson(hint, level, lang));
  else terminal.line(printable(hint === null ? passedText(lang) : hintText(hint, level, lang)));
  return hint === null ? 0 : 3;
}
