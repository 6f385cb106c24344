import { computed } from 'vue';

import { promptOf } from './log/prompt';
import type { TextKey } from '../../kit/i18n/texts';
import type { RunParts } from '../../session/run/parts';
import type { WorkParts } from '../../session/work/model/parts';
import type { ConsoleParts } from './parts';

/** The present use of the serial line: text for the program, lines for the REPL, or none. */
export function useRepl({
  run,
  console,
  work,
}: Pick<RunParts, 'run'> & Pick<WorkParts, 'work'> & Pick<ConsoleParts, 'console'>) {
  const ended = run.ended;
  /** True once the REPL has greeted; before that the display shows the error, half a minute at times. */
  const isRepl = computed(() => run.isActive.value && ended.value !== null && run.shown.value?.repl === true);
  /** True after an error until somebody turns to the REPL: its card says all, and has the way there. */
  const isCardAll = computed(
    () => run.past.value === null && ended.value?.kind === 'exception' && !console.isReplVisited.value,
  );
  const readsInput = computed(() => work.files.value.some(({ text }) => /\binput\s*\(/.test(text)));
  return {
    isRepl,
    /** True while the display shows the error: the device reads no lines yet. */
    isErrorShown: computed(() => run.isActive.value && isCardAll.value && !isRepl.value),
    /** True if there is a line for the device: not without a run, after a panic, or while an error's card says all. */
    isOpen: computed(
      () => run.isActive.value && !isCardAll.value && !['panic', 'fault'].includes(ended.value?.kind ?? ''),
    ),
    mark: computed(() => (isRepl.value ? promptOf(console.entries.value) : '>')),
    /** The text in the field: its use at present. */
    hint: computed((): TextKey => {
      if (run.past.value !== null) return 'console.pastInput';
      if (run.isWaitingForInput.value) return 'console.input';
      if (ended.value !== null) return 'console.replInput';
      return readsInput.value ? 'console.input' : 'console.sendInput';
    }),
  };
}
