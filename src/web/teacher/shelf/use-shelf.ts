import type { ShelfWork } from '#check/shelf/shelf';

import { t } from '../../kit/i18n';
import type { PageParts } from '../../kit/parts';
import { askBeforeLeaving } from '../../kit/state/ask-before-leaving';
import { lateModel } from '../../kit/state/late-models';
import { TaskShelf } from './task-shelf';
import { workNameOf } from './work-name-of';
import words from './words';

/** The shelf of this browser. Leaving the page asks if something on it would be lost. */
export const shelfOf = lateModel(() => {
  const shelf = new TaskShelf();
  askBeforeLeaving(() => shelf.isUnsaved.value);
  return shelf;
});

/** Puts a work onto the shelf and says so, with a button that takes it back. */
export async function keepOnShelf(app: Pick<PageParts, 'notices' | 'late'>, work: ShelfWork): Promise<void> {
  const { isNew, isStored, undo } = await shelfOf(app).keep(work);
  const name = workNameOf(work);
  const text = isStored ? t(isNew ? words.kept : words.renewed, { name }) : t(words.noRoom, { name });
  app.notices.show({
    ...{ kind: isStored ? 'ok' : 'error', key: 'notice.text', values: { text } },
    ...(isStored && { action: { key: 'notice.undo', run: () => void undo() } }),
  });
}
