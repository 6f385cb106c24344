import { latePart } from '../../kit/late-part';
import type { PageParts } from '../../kit/parts';
import type { WorkParts } from '../work/model/parts';
import type { Unsaved } from '../work/model/unsaved';

/** Tells that the work is stored nowhere, with a button that saves it as a file, until it is stored again. */
export function sayUnsaved(app: Pick<PageParts, 'notices'> & WorkParts, why: Unsaved | null): void {
  const { notices, work } = app;
  work.unsaved.value = why;
  if (why === null) return;
  const save = (): void =>
    void import('../work/save-work').then(
      ({ saveProject }) => saveProject(app),
      () => notices.show(latePart),
    );
  notices.show({
    ...{ kind: 'error', key: why === 'full' ? 'files.storageFull' : 'files.storageForbidden' },
    action: { key: 'bar.save', run: save },
    holds: () => work.unsaved.value === why,
  });
}
