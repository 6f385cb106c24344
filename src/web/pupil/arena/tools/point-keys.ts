import { linePointRemoved } from '#editor/lines/points-tool';
import type { SelectionKeyPorts, SelectionKeys } from './tool-keys';
import type { ToolSurface } from './tool-surface';

/**
 * The keys for the selection, and others while the points of a line are edited: Delete removes the point under the
 * pointer or the crosshair, the arrows are left to the crosshair; keys with Ctrl work on the whole line.
 */
export function withPointKeys(
  whole: SelectionKeys,
  ports: SelectionKeyPorts,
  surface: ToolSurface,
  isBending: () => boolean,
): SelectionKeys {
  const removePoint = (): void => {
    const { crosshair, hover } = surface.picture();
    const at = crosshair?.at ?? hover;
    const edit = at && linePointRemoved(ports.context(), at, surface.reachMm);
    if (edit) ports.commit(edit);
  };
  return {
    get edit() {
      return whole.edit;
    },
    keyDown(key, fine, command) {
      if (command || !isBending()) return whole.keyDown(key, fine, command);
      if (key !== 'Delete' && key !== 'Backspace') return false;
      removePoint();
      return true;
    },
    keyUp: (key) => whole.keyUp(key),
  };
}
