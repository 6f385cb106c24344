import { Compartment, type Extension } from '@codemirror/state';
import { ViewPlugin, type EditorView, type ViewUpdate } from '@codemirror/view';

import { columnLook, deviceColumn } from './device-gutter';
import type { DeviceMarksOptions } from './device-question';

/** The check comes after the editor can be used. Chosen: pages must be usable first (architecture.md, budgets). */
const LOAD_AFTER_MS = 1500;

/** A place for the marks at what would not run on the device; filled a little after there is something to check. */
export function deviceMarks(options: DeviceMarksOptions): Extension {
  const slot = new Compartment();
  return [deviceColumn, columnLook, slot.of([]), ViewPlugin.define((view) => fillWhenNeeded(view, slot, options))];
}

function fillWhenNeeded(view: EditorView, slot: Compartment, options: DeviceMarksOptions) {
  let gone = false;
  let timer: ReturnType<typeof setTimeout> | undefined;
  async function fill(): Promise<void> {
    if (isFilled(view, slot)) return;
    const { deviceLint } = await import('./device-lint');
    if (gone || isFilled(view, slot)) return;
    view.dispatch({ effects: slot.reconfigure(deviceLint(options)) });
  }
  /** A first visit is spared the check: our own programs were checked before. */
  function look(edited: boolean): void {
    if (timer !== undefined || isFilled(view, slot)) return;
    if (options.question() === null || (!edited && options.isOurs())) return;
    // Without a connection there are no marks; the next change tries again.
    const fillOrForget = (): void => void fill().catch(() => (timer = undefined));
    timer = setTimeout(fillOrForget, edited ? 0 : LOAD_AFTER_MS);
  }
  const stop = options.onChange(() => look(false));
  look(false);
  return {
    update: ({ docChanged }: ViewUpdate) => {
      if (docChanged) look(true);
    },
    destroy: () => {
      gone = true;
      stop();
      clearTimeout(timer);
    },
  };
}

/**
 * True if it is filled already, as in a file that was shown before, or if another file is shown, whose slot is its own.
 */
function isFilled(view: EditorView, slot: Compartment): boolean {
  const now = slot.get(view.state);
  return now === undefined || !Array.isArray(now) || now.length > 0;
}
