// Makes the page: node make.mjs ARMS OUT, in a folder with these sources and node_modules.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const [arms_folder, out] = process.argv.slice(2);
const arms = {};
for (const name of readdirSync(arms_folder).filter((file) => file.endsWith(".json")).sort()) {
  const { name: arm, convention, dh, X_WB, X_6T, X_NT } = JSON.parse(readFileSync(`${arms_folder}/${name}`, "utf8"));
  const rows = dh.map(({ type, alpha_deg, a_mm, theta_deg, d_mm }) => ({ type, alpha_deg, a_mm, theta_deg, d_mm }));
  arms[arm] = { convention, dh: rows, X_WB, X_6T, X_NT };
}
const made = await build({
  entryPoints: ["main.js"],
  bundle: true,
  minify: true,
  write: false,
  format: "iife",
  target: ["es2022"],
  legalComments: "none",
  plugins: [
    {
      name: "arms",
      setup(how) {
        how.onResolve({ filter: /^arms$/ }, () => ({ path: "arms", namespace: "arms" }));
        how.onLoad({ filter: /.*/, namespace: "arms" }, () => ({ contents: JSON.stringify(arms), loader: "json" }));
      },
    },
  ],
});
const script = made.outputFiles[0].text.replaceAll("</script", "<\\/script");
const style = readFileSync("style.css", "utf8");
const hash = (text) => `'sha256-${createHash("sha256").update(text).digest("base64")}'`;
const policy =
  `default-src 'none'; script-src ${hash(script)}; style-src ${hash(style)}; ` +
  "connect-src ws://127.0.0.1:* ws://localhost:* ws://[::1]:*; base-uri 'none'; form-action 'none'";
const licence = readFileSync("node_modules/three/LICENSE", "utf8").trim();
const page = readFileSync("index.html", "utf8")
  .replace("<!doctype html>", () => `<!doctype html>\n<!-- Contains three.js.\n\n${licence}\n-->`)
  .replace("@POLICY@", () => policy)
  .replace("@STYLE@", () => style)
  .replace("@SCRIPT@", () => script);
writeFileSync(out, page);
