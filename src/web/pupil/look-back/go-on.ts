import type { PageParts } from '../../kit/parts';
import type { RunParts } from '../../session/run/parts';
import { goOn } from '../../session/run/run-again';
import { isChanged } from '../../session/work/is-changed';
import type { WorkParts } from '../../session/work/model/parts';
import words from './words';

/**
 * Goes on from the moment that is looked at. If the program has been written on since the run began, it asks with which
 * one: that of the run, or the new one, which can only begin at its start.
 */
export function goOnFromHere(app: Pick<PageParts, 'dialogs'> & Pick<RunParts, 'run'> & Pick<WorkParts, 'work'>): void {
  const { run, dialogs } = app;
  const asItRan = (): void => void goOn(run, run.nowUs.value);
  if (!isChanged(app)) return asItRan();
  dialogs.ask({
    ...{ kind: 'choose', title: words.goOn, text: words.changedSince, values: {} },
    choices: [
      { key: words.asItRan, look: 'outline', run: asItRan },
      { key: words.anew, look: 'run', run: () => run.press() },
    ],
  });
}
