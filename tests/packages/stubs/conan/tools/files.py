import pathlib
import shutil


def copy(_recipe, pattern, source, target):
    for file in pathlib.Path(source).rglob(pattern):
        if file.is_file():
            place = pathlib.Path(target) / file.relative_to(source)
            place.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, place)
