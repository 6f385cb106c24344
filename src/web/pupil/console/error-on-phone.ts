import type { LayoutParts } from '../../session/layout/parts';
import type { PageParts } from '../../kit/parts';
import type { RunModel } from '../../session/run/run-model';
import type { WorkParts } from '../../session/work/model/parts';
import type { Ended } from '#simulation/simulation';

import { fetchAdvice } from './advice/explain';
import { errorText } from './error-text';

/** The models that show the error and its line. */
type PhoneParts = WorkParts & Pick<PageParts, 'notices'> & Pick<LayoutParts, 'layout'>;

/** Shows a notice of an error on a phone, with the way to the program, which has the remedy, or else to the console. */
export async function showErrorOnPhone(parts: PhoneParts, ended: Ended, run: RunModel): Promise<void> {
  const { layout, notices } = parts;
  const tab = layout.tabs.value.includes('code') ? 'code' : 'console';
  const show = (): void => void (layout.tab.value = tab);
  await fetchAdvice();
  const text = errorText(ended, parts);
  if (text !== null && run.ended.value === ended && !layout.isShown.value[tab])
    notices.show({ kind: 'error', ...text, action: { key: `nav.${tab}`, run: show } });
}
