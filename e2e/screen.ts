import { spawn } from 'node:child_process';
import { once } from 'node:events';

/** A screen without a monitor. */
export interface Screen {
  close(): Promise<void>;
}

/**
 * Gives this test worker a screen of its own where `npm run e2e` asks for it: on a common one a window that opens takes
 * the focus from the other worker's, whose page then lets go of held keys and closes its lists.
 */
export async function startScreen(): Promise<Screen | null> {
  if (process.env['PARCOURS_OWN_SCREENS'] === undefined) return null;
  const server = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', '1600x1200x24', '-nolisten', 'tcp'], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  });
  const number = server.stdio[3];
  if (!number) throw new Error('Xvfb has no way to tell its number.');
  const [told] = (await once(number, 'data')) as [Buffer];
  process.env['DISPLAY'] = `:${told.toString().trim()}`;
  return {
    close: async () => {
      const ended = once(server, 'exit');
      server.kill();
      await ended;
    },
  };
}
