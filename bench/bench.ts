/** npm run bench: prints one line per budget: what | figure | budget. */
import { headlessRows } from './headless';

for (const { what, figure, budget } of await headlessRows()) console.log(`${what} | ${figure} | ${budget}`);
