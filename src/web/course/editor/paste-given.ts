import type { Vec } from '#core/geometry';

import { t } from '../../kit/i18n';
import type { PageParts } from '../../kit/parts';
import type { WorkParts } from '../../session/work/model/parts';
import editingWords from './words/editing';
import type { CourseEditorParts } from './state/parts';
import type { SelectionActs } from './state/selection-acts';

/** The models that pasting works on. */
export type PasteParts = Pick<PageParts, 'notices'> & WorkParts & CourseEditorParts;

/**
 * Pastes the objects that a text of the system's clipboard holds. For any other text a message says that it holds none,
 * unless something was copied here that has not reached that clipboard: then that is pasted.
 *
 * @param at where they shall lie, world mm; left out: where the pointer is, or where they came from
 */
export function pasteGiven({ editor, notices }: PasteParts, acts: SelectionActs, text: string, at?: Vec): void {
  const { clipboard } = editor;
  if (acts.pasteText(text, at)) return;
  if (!clipboard.isEmpty && (!clipboard.isWithSystem || text === '')) acts.paste(at);
  else notices.show({ kind: 'info', key: 'notice.text', values: { text: t(editingWords.menu.foreign) } });
}
