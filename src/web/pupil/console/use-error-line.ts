import { computed } from 'vue';

import { useLayout } from '../../session/layout/parts';
import { useWork } from '../../session/work/model/parts';
import { useConsole } from './parts';

/** The error that stands below the program of a phone: that of the last run, until the program is another. */
export function useErrorLine() {
  const { console } = useConsole();
  const { layout } = useLayout();
  const { work } = useWork();
  return computed(() => {
    if (layout.kind.value !== 'phone') return null;
    const latest = console.entries.value.findLast((entry) => entry.kind === 'error' || entry.kind === 'run');
    if (latest?.kind !== 'error' || latest.place === null) return null;
    const { id, place, report } = latest;
    const file = work.files.value.find(({ name }) => name === place.file);
    return file?.text === report.source?.text ? { id, place, report } : null;
  });
}
