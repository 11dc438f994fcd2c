// Worker that runs the solver.
import { begin, reply_to } from './compute.js';

onmessage = async ({ data: message }) => {
  if (!message.wasm) return postMessage(reply_to(message));
  try {
    await begin(message);
    postMessage({ ready: true });
  } catch (error) {
    postMessage({ lost: String(error) });
  }
};
