import { computed } from 'vue';

import { shownLanguage, t } from '../../kit/i18n';
import { decimalSign } from '../../kit/i18n/number-text';
import type { TextKey } from '../../kit/i18n/texts';
import type { RunParts } from './parts';

/** Minutes, seconds and tenths of simulated time: `00:42.6`, in French `00:42,6`; with `fine` also hundredths, in which a step shows. */
export function clockText(timeUs: number, fine = false): string {
  const whole = Math.floor(timeUs / 1_000_000);
  const part = Math.floor((timeUs % 1_000_000) / (fine ? 10_000 : 100_000));
  const two = (number: number): string => String(number).padStart(2, '0');
  return `${two(Math.floor(whole / 60))}:${two(whole % 60)}${decimalSign(shownLanguage())}${fine ? two(part) : part}`;
}

/** The run's state in a word, its colour, and its clock. @param device place of the one that it is about; left out: the one that is shown */
export function useRunText({ run }: Pick<RunParts, 'run'>, device: () => number = () => run.device) {
  const state = computed((): { key: TextKey; tone: 'run' | 'stop' | 'warn' | '' } => {
    const ended = run.endings.value[device()] ?? null;
    if (ended?.kind === 'panic' && run.isActive.value) return { key: 'state.panic', tone: 'stop' };
    if (ended !== null && ended.exception !== null) return { key: 'state.failed', tone: 'stop' };
    switch (run.phase.value) {
      case 'starting':
        return { key: 'state.starting', tone: 'run' };
      case 'running':
        if (ended === null && run.deviceNow(device())?.awaitsInput === true)
          return { key: 'state.waiting', tone: 'warn' };
        return { key: ended === null ? 'state.running' : 'state.finished', tone: 'run' };
      case 'paused': // whoever builds after the program's end pauses a world in which nothing more happens
        return ended === null ? { key: 'state.paused', tone: 'warn' } : { key: 'state.finished', tone: 'run' };
      case 'stopping':
      case 'stopped':
        return { key: 'state.stopped', tone: '' };
      case 'killed':
        return { key: 'state.killed', tone: 'warn' };
      case 'failed':
        return { key: 'state.failed', tone: 'stop' };
      case 'ready':
        return { key: 'state.ready', tone: '' };
    }
  });
  return {
    tone: computed(() => state.value.tone),
    stateText: computed(() => t(state.value.key)),
    timeText: computed(() => clockText(run.nowUs.value, run.phase.value === 'paused')),
  };
}
