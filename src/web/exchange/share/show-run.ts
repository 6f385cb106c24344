import { watch } from 'vue';

import { showAgain, type RunAgain } from '../../session/run/run-again';
import type { Workplace } from '../../session/work/model/parts';

/** Shows a run that was repeated. */
export async function showRun(
  app: Workplace,
  { first, pieces }: Pick<RunAgain, 'first' | 'pieces'>,
  run: Omit<RunAgain, 'first' | 'pieces'>,
): Promise<void> {
  if (!app.settings.current.value.showArena) app.settings.change({ showArena: true });
  await showAgain(app.run, { ...run, first, pieces });
}

/** Notices when somebody opens something else, or runs the program: then nobody wants to see this run any more. */
export function watchLate({ work, run }: Workplace, act: () => void): { (): boolean; readonly end: () => void } {
  let isLate = false;
  const end = watch(
    [() => work.openings.value, () => run.phase.value === 'starting'],
    () => {
      isLate = true;
      act();
    },
    { flush: 'sync' },
  );
  return Object.assign(() => isLate, { end });
}

/** Shows a message in place of the one about the opening, and keeps its way back to the earlier work. */
export function tell(
  { notices }: Workplace,
  kind: 'ok' | 'info' | 'warn',
  text: string,
  action = notices.current.value?.action,
): void {
  notices.show({ kind, key: 'notice.text', values: { text }, ...(action && { action }) });
}
