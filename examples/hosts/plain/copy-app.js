// Puts the app, which the package brings along, among the files that this page serves.
import { cp, rm } from 'node:fs/promises';

await rm('public/parcours', { recursive: true, force: true });
await cp('node_modules/parcours-element/app', 'public/parcours', { recursive: true });
