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
  /** True while the display shows the error: the device reads no lines yet, and the error's card says all. */
  const isErrorShown = computed(
    () => run.past.value === null && run.isActive.value && ended.value?.kind === 'exception' && !isRepl.value,
  );
  const readsInput = computed(() => work.files.value.some(({ text }) => /\binput\s*\(/.test(text)));
  return {
    isRepl,
    isErrorShown,
    /** True if the device reads the line: not without a run, and not after a panic. */
    isOpen: computed(() => run.isActive.value && ended.value?.kind !== 'panic' && ended.value?.kind !== 'fault'),
    mark: computed(() => (isRepl.value ? promptOf(console.entries.value) : '>')),
    /** The text in the field: its use at present. */
    hint: computed((): TextKey => {
      if (run.past.value !== null) return 'console.pastInput';
      if (run.isWaitingForInput.value) return 'console.input';
      if (ended.value?.kind === 'exception' && !isRepl.value) return 'console.errorShown';
      if (ended.value !== null) return 'console.replInput';
      return readsInput.value ? 'console.input' : 'console.sendInput';
    }),
  };
}
