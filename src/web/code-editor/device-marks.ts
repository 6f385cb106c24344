import { Compartment, type Extension } from '@codemirror/state';
import { ViewPlugin, type EditorView } from '@codemirror/view';

import { columnLook, deviceColumn } from './device-gutter';
import type { DeviceMarksOptions } from './device-question';

/** The check comes after the editor can be used. Chosen: pages must be usable first (architecture.md, budgets). */
const LOAD_AFTER_MS = 1500;

/** A place for the marks at what would not run on the device; filled a little after the editor is there. */
export function deviceMarks(options: DeviceMarksOptions): Extension {
  const slot = new Compartment();
  return [deviceColumn, columnLook, slot.of([]), ViewPlugin.define((view) => fillLater(view, slot, options))];
}

function fillLater(view: EditorView, slot: Compartment, options: DeviceMarksOptions): { destroy(): void } {
  let gone = false;
  const timer = setTimeout(() => void fill(), LOAD_AFTER_MS);
  async function fill(): Promise<void> {
    if (isFilled(view, slot)) return;
    const { deviceLint } = await import('./device-lint');
    if (gone || isFilled(view, slot)) return;
    view.dispatch({ effects: slot.reconfigure(deviceLint(options)) });
  }
  return {
    destroy: () => {
      gone = true;
      clearTimeout(timer);
    },
  };
}

/** Filled already, as in a file that was shown before; or another file is shown, whose slot is its own. */
function isFilled(view: EditorView, slot: Compartment): boolean {
  const now = slot.get(view.state);
  return now === undefined || !Array.isArray(now) || now.length > 0;
}
