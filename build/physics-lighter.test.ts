import { readFile } from 'node:fs/promises';

import { build, type Rolldown } from 'vite';
import { describe, expect, it } from 'vitest';

import { lightened, physicsLighter } from './physics-lighter.ts';

const ENTRY = 'virtual:entry';

/** The code of a bundle with what we take from the engine. */
async function bundle(): Promise<string> {
  const made = (await build({
    configFile: false,
    logLevel: 'silent',
    plugins: [
      physicsLighter(),
      {
        name: 'entry',
        resolveId: (id) => (id === ENTRY ? id : null),
        load: (id) =>
          id === ENTRY
            ? "export { CircleShape, Joint, PolygonShape, Rot, Settings, Vec2, World } from 'planck';"
            : null,
      },
    ],
    build: { write: false, minify: false, rolldownOptions: { input: ENTRY, preserveEntrySignatures: 'strict' } },
  })) as Rolldown.RolldownOutput;
  return made.output[0].code;
}

describe('the physics engine in a bundle', () => {
  it('has the shapes that courses are made of, and neither the joints nor the shapes that nobody makes', async () => {
    const code = await bundle();
    for (const needed of ['CircleShape', 'PolygonShape', 'CollidePolygons']) expect(code).toContain(needed);
    expect(code).not.toMatch(/wheel-joint|gear-joint|distance-joint|ChainShape2|DESERIALIZE/);
  });

  it('lets a build fail with an engine that it does not know', async () => {
    const engine = await readFile('node_modules/planck/dist/planck.mjs', 'utf8');
    expect(() => lightened(engine.replace('Serializer.toJson =', 'Serializer.write ='))).toThrow('not 2');
  });
});
