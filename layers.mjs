/** Who may import whom: each room of `src/` and the rooms it may reach. Enforced by `npm run check`. */
export const layers = {
  core: [],
  board: ['core'],
  vm: ['core', 'board'],
  devices: ['core', 'board'],
  world: ['core'],
  robots: ['core', 'board', 'devices', 'world'],
  scene: ['core'],
  editor: ['core', 'scene'],
  simulation: ['core', 'board', 'vm', 'devices', 'world', 'robots', 'scene'],
  embed: ['core', 'scene'],
  cli: ['core', 'board', 'robots', 'scene', 'simulation'],
  web: ['core', 'board', 'vm', 'devices', 'world', 'robots', 'scene', 'editor', 'simulation', 'embed'],
};
