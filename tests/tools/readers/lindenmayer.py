"""npm's lindenmayer: node runs the module, whose turtle gives the placements."""
import json
import shutil
import subprocess
from pathlib import Path

from .picture import Disagreement

FORMAT = "lindenmayer"
ENDING = ".mjs"
LIMIT = 1e-9

INSTALLED = Path(__file__).resolve().parents[3] / "build/npm"


def missing():
    if not shutil.which("node"):
        return "node is not installed (Debian: nodejs)"
    if not (INSTALLED / "node_modules/lindenmayer").is_dir():
        if not shutil.which("npm"):
            return "npm is not installed"
        INSTALLED.mkdir(parents=True, exist_ok=True)
        done = subprocess.run(["npm", "install", "--silent", "--no-audit", "--no-fund", "--prefix", str(INSTALLED), "lindenmayer"],
                              capture_output=True, text=True, timeout=300)
        if done.returncode != 0:
            return "npm cannot install lindenmayer: " + done.stderr.strip()[:200]
    return None


def read(exported, picture, folder):
    (folder / "node_modules").symlink_to(INSTALLED / "node_modules")
    done = subprocess.run(["node", exported.name], cwd=folder, capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        raise Disagreement("node: " + done.stderr.strip()[:300])
    found = json.loads(done.stdout)
    for placement, want in zip(found, picture.placements):
        if placement["style"] != want["style"] or placement["layer"] != want["layer"]:
            raise Disagreement(f"{placement['terminal']} has another style or layer")
    return [picture.element(placement["terminal"], placement["matrix"]) for placement in found]
