import { describe, expect, it } from 'vitest';
import { lastLine, parcours, useFolder } from './testing/parcours';

const { file } = useFolder();

describe('parcours run with a robot that does not fit', { timeout: 60_000 }, () => {
  const forLite = file('lite.py', 'from mbrobot import *\nstop()\n');

  it('says for which robot the program is when another one is chosen', () => {
    expect(parcours('run', forLite, '--robot', 'maqueen-plus-v2').err).toContain(
      'the program is for the Maqueen Lite, but the robot here is the Maqueen Plus V2. Choose --robot maqueen-lite.',
    );
  });

  it('says so too when there is no robot at all', () => {
    expect(parcours('run', forLite, '--robot', 'none').err).toContain('but there is no robot here');
  });

  it('refuses an option of a robot where there is none', () => {
    const { err, code } = parcours('run', file('bare.py', ''), '--robot', 'none', '--option', 'S1=claw');
    expect(err).toBe('parcours: --option S1: there is no robot here. Leave it out, or choose --robot.\n');
    expect(code).toBe(2);
  });

  it('explains the error with that, in the report, as the page does', () => {
    const { out } = parcours(
      'run',
      forLite,
      '--robot',
      'callibot',
      '--board',
      'calliope-mini-3',
      '--json',
      '--lang',
      'de',
    );
    const { exception } = lastLine(out);
    expect(exception?.advice).toBe(
      'Dieses Programm ist für den Maqueen Lite, gewählt ist der Calli:bot. Wähle den Maqueen Lite unter Gerät.',
    );
  });

  it('names the robots that there are where the library of another one is imported', () => {
    const { err } = parcours('run', file('minibit.py', 'from mbminibit import *\n'));
    expect(err).toMatch(/mbminibit belongs to the robot 4tronix minibit\. It is not here\. There are: .*Maqueen Lite/);
  });

  it('says on which microcomputer the robot belongs when it stands on the other', () => {
    const { err } = parcours('run', forLite, '--robot', 'maqueen-lite', '--board', 'calliope-mini-3');
    expect(err).toContain('made for the micro:bit V2');
  });

  it('says nothing when all fits, or when nobody can tell', () => {
    expect(parcours('run', forLite).err).toBe('');
    expect(parcours('run', file('bare.py', 'from microbit import *\n'), '--robot', 'callibot').err).toBe('');
  });
});
