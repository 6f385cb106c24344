import { parseShelf } from '#check/shelf/read-shelf';
import { shelfLimits, type ShelfList, type ShelfWork } from '#check/shelf/shelf';
import { projectLimits } from '#project/project';
import { documentOfText, taskIn } from '#intake/text';
import { readTasks } from '#intake/read-files';

import { t } from '../../kit/i18n';
import { decodedAddress, fetchOwn, pageAddress, type Fetched } from '../../exchange/share/own-server';
import { unreadableReason } from '../../exchange/share/unreadable-words';
import { readyScene } from '../../session/work/catalogue/ready-courses';
import words from './words';

/** Why something cannot be shown, in words. */
export interface Refused {
  readonly problem: string;
}

const faultText = ({ fault, values }: Exclude<Fetched, { readonly text: string }>): string => t(words[fault], values);

/** The list of a school's shelf, and its address. Never rejects. @param given address of the list, seen from the page */
export async function fetchShelf(given: string): Promise<{ readonly list: ShelfList; readonly url: string } | Refused> {
  const fetched = await fetchOwn(decodedAddress(given), pageAddress(), shelfLimits.characters);
  if ('fault' in fetched) return { problem: faultText(fetched) };
  const read = parseShelf(fetched.text);
  if ('list' in read) return { list: read.list, url: fetched.url };
  const reason = read.problem;
  return { problem: read.isShelf ? t(words.badList, { reason }) : t(words.noList, { address: given }) };
}

/** A work of a shelf. Never rejects. @param file its address, seen from the list @param list address of that */
export async function fetchWork(file: string, list: string): Promise<{ readonly work: ShelfWork } | Refused> {
  const fetched = await fetchOwn(file, list, projectLimits.textCharacters);
  if ('fault' in fetched) return { problem: faultText(fetched) };
  const document = documentOfText(fetched.text, readyScene);
  if (document.kind === 'series') {
    const series = await readTasks(document.series, async (beside) => {
      const read = await fetchOwn(beside, fetched.url, projectLimits.textCharacters);
      return 'fault' in read ? { problem: faultText(read) } : read;
    });
    return { work: { kind: 'series', series } };
  }
  const task = taskIn(document);
  return 'project' in task ? { work: { kind: 'task', project: task.project } } : { problem: unreadableReason(task) };
}
