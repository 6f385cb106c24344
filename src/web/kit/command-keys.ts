import { onScopeDispose } from 'vue';

/** Keys that do something together with Ctrl or ⌘, by their names in small letters; `shift+` with Shift as well. */
export type CommandKeys = Readonly<Record<string, () => void>>;

/** The properties of a key pressed together with Ctrl or ⌘. */
export type CommandKey = Pick<KeyboardEvent, 'key' | 'altKey' | 'shiftKey' | 'repeat' | 'preventDefault'>;

/** Listens to keys of the whole page that are pressed together with Ctrl or ⌘. */
export function useCommandKeys(keys: CommandKeys): void {
  const down = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey) command(event, keys);
  };
  addEventListener('keydown', down);
  onScopeDispose(() => removeEventListener('keydown', down));
}

/** Does what a key means together with Ctrl or ⌘; the others stay the browser's. */
export function command(event: CommandKey, keys: CommandKeys): void {
  if (event.altKey || event.repeat) return;
  const act = keys[(event.shiftKey ? 'shift+' : '') + event.key.toLowerCase()]; // with Caps Lock it is an S
  if (act === undefined) return;
  act();
  event.preventDefault();
}
