/** What the host page runs: the client, as a page without a bundler would take it from a file. */
import { connect } from '#embed/client/connect';

Object.assign(globalThis, { connect });
