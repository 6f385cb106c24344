/** The script of the host page: the client, as a page without a bundler would load it from a file. */
import { connect } from '#embed/client/connect';

Object.assign(globalThis, { connect });
