/** Longest unfinished line that waits for its end. Chosen: a screenful. */
const MOST_WAITING = 4000;

/**
 * Brings the output of several devices onto one terminal: whole lines, each with the name of its device.
 *
 * @param names of the devices, by place
 */
export function createDeviceLines(names: readonly string[], show: (text: string) => void) {
  const waiting = names.map(() => '');
  const lineOf = (device: number, text: string): string => `${names[device] ?? ''}: ${text}\n`;
  return {
    add(device: number, text: string): void {
      const lines = `${waiting[device] ?? ''}${text.replaceAll('\r\n', '\n')}`.split('\n');
      const rest = lines.pop() ?? '';
      const isLong = rest.length > MOST_WAITING;
      waiting[device] = isLong ? '' : rest;
      show([...lines, ...(isLong ? [rest] : [])].map((line) => lineOf(device, line)).join(''));
    },
    /** Shows the lines that did not end. */
    end(): void {
      show(waiting.map((rest, device) => (rest === '' ? '' : lineOf(device, rest))).join(''));
      waiting.fill('');
    },
  };
}
